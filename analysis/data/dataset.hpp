#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/data/trial.hpp"

namespace bimodal::analysis {

struct SourceFile {
  std::string name;    ///< as the user named it
  std::string sha256;  ///< of its bytes when it was read

  bool operator==(const SourceFile&) const = default;
};

/// What is worth telling about a session, besides its trials.
struct SessionSummary {
  std::size_t file = 0;  ///< index into Dataset::files
  std::int64_t id = 0;   ///< within its file
  std::string participant;
  int participant_number = 1;
  int session_number = 1;
  std::string protocol_title;
  std::string protocol_sha256;
  std::uint64_t seed = 0;
  std::string program_version;
  std::string started_utc;
  std::string outcome;       ///< "complete", "stopped", "interrupted"
  std::string observer;      ///< of simulated answers; empty for people
  bool simulated = false;    ///< a simulated observer answered, or time was virtual
  int planned_trials = 0;    ///< practice included
  std::string face_quality;  ///< "fast", "full"; empty: no synthetic face was drawn, or unknown
  std::string face_quality_basis;     ///< why: "protocol", "measured", "unwatched"
  bool shortened = false;             ///< by --trials or --no-practice of `run` or `rehearse`
  int stored_trials = 0;              ///< practice included
  int analysed_trials = 0;            ///< left after all exclusions
  std::optional<int> flagged_trials;  ///< among the stored; absent: their timing is not known
};

/// Trials that were stored but are not analysed. A trial is counted once, under its first reason.
struct Exclusion {
  std::string reason;
  std::int64_t trials = 0;

  bool operator==(const Exclusion&) const = default;
};

/// All that is analysed, and how it came to be so.
struct Dataset {
  std::vector<SourceFile> files;
  std::vector<SessionSummary> sessions;
  std::vector<Trial> trials;  ///< sessions in order of files, trials in order of presentation
  std::vector<Exclusion> exclusions;  ///< every reason that was looked for, with 0 where none fell
  std::vector<std::string> warnings;  ///< what a reader of the numbers must know
  std::int64_t stored_trials = 0;     ///< analysed and excluded together
};

}  // namespace bimodal::analysis

#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "analysis/data/dataset.hpp"

namespace bimodal::analysis {

/// Which trials are wanted.
struct Selection {
  bool include_practice = false;
  bool exclude_flagged = false;
  bool exclude_simulated = false;
  std::optional<Duration> fastest;        ///< shorter response times are left out
  std::optional<Duration> slowest;        ///< longer ones are left out
  std::vector<std::string> conditions;    ///< by name; empty: all
  std::vector<std::string> participants;  ///< by name; empty: all
};

/// A session and all of its trials.
struct SessionTrials {
  SessionSummary summary;
  std::vector<Trial> trials;
};

/// The trials of one file, of whatever kind.
struct TrialsOfFile {
  SourceFile file;
  std::vector<SessionTrials> sessions;
  std::vector<std::string> warnings;  ///< about the file itself
};

/// For messages, which names the data have: "there is only A", "there are A, V", "there are none".
[[nodiscard]] std::string names_there(const std::set<std::string>& names);

/// Chooses trials and counts what is left out. The response time of a trial is that of its first
/// key, or of its submission where no key is known; trials without either are not judged by it.
/// Throws Error for a selected condition or participant that does not occur.
[[nodiscard]] Dataset gather(std::vector<TrialsOfFile>&& files, const Selection& selection = {});

}  // namespace bimodal::analysis

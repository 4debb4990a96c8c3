#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runner/store/records.hpp"

namespace bimodal::runner {

/// One trial that took place, with its plan. What analysis reads.
struct StoredTrial {
  PlanRecord plan;
  TrialRecord trial;
};

struct StoredSession {
  SessionRecord session;
  std::string outcome;              ///< "complete", "stopped", or "" if it was interrupted
  std::vector<StoredTrial> trials;  ///< in order of presentation
  int planned_trials = 0;
  bool shortened = false;  ///< by --trials or --no-practice
};

/// How much of each trial to read; refreshes and keystrokes are most of the bytes.
enum class Detail { Responses, Everything };

/// Every session of a SQLite file, which is opened read-only. Throws StoreError.
[[nodiscard]] std::vector<StoredSession> read_sessions(const std::filesystem::path& file,
                                                       Detail detail = Detail::Responses);

/// What was planned for one session of a SQLite file, in order; trials that repeat others are not
/// in it. Throws StoreError.
[[nodiscard]] std::vector<PlanRecord> read_plan(const std::filesystem::path& file,
                                                std::int64_t session);

/// The number that a trial gets that is added to the plan of one session: one above the highest,
/// repetitions included, whether they took place or not. Throws StoreError.
[[nodiscard]] std::size_t next_trial(const std::filesystem::path& file, std::int64_t session);

}  // namespace bimodal::runner

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "protocols/design/plan.hpp"
#include "protocols/reading/read_protocol.hpp"
#include "runner/store/records.hpp"

namespace bimodal::runner {

/// A session that was stopped or cut off, and what of it is stored.
struct Resumption {
  std::int64_t session = 0;
  std::set<std::size_t> done;  ///< indices into the plan
  /// The number of the next trial that repeats another: after all that were planned so far.
  std::size_t next_trial = 0;
  int flagged = 0;                  ///< of the trials that are stored, repetitions among them
  std::vector<std::size_t> owed{};  ///< were to be presented again, and have not been
  std::optional<TimingRecord> timing{};
  std::string sound_levels;
};

/// Throws Error if the session would go on at other levels or with another calibration than it
/// began with: one row of the data file states them for all its trials.
void require_same_terms(const Resumption& resumption, const SessionRecord& record);

/// The last session of this participant with this protocol and session number in `data` that is not
/// complete. Throws Error if there is none, if a session that stores in this file is running, or if
/// what was planned then is not `plan` (another protocol, other --trials or --no-practice, other
/// --with or --without).
[[nodiscard]] Resumption find_resumption(const std::filesystem::path& data,
                                         const std::string& participant,
                                         protocols::SessionKey key,
                                         const protocols::ReadProtocol& read,
                                         const std::vector<protocols::PlannedTrial>& plan);

/// The trials of the plan that are not done.
[[nodiscard]] std::vector<protocols::PlannedTrial> rest_of(
    const std::vector<protocols::PlannedTrial>& plan, const std::set<std::size_t>& done);

}  // namespace bimodal::runner

#pragma once

#include "protocols/model/response.hpp"
#include "runner/session/trial_machine.hpp"
#include "runner/store/records.hpp"

namespace bimodal::runner {

/// The answer as it is stored, with the instant from which its reaction time counts: of an onset
/// the one that the device reported; the planned one if it reported none. A trial that does not
/// have the onset (checked protocols have none) counts from its planned end, and says so. `trial`
/// has its onsets and its end.
[[nodiscard]] ResponseRecord response_record(const RecordResponse& response,
                                             protocols::RtFrom from,
                                             const TrialRecord& trial);

}  // namespace bimodal::runner

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "protocols/design/plan.hpp"
#include "protocols/reading/read_protocol.hpp"
#include "runner/devices/audio_output.hpp"
#include "runner/devices/display.hpp"
#include "runner/store/records.hpp"

namespace bimodal::runner {

/// Which part of a plan is to be run; for trying out.
struct Shortening {
  std::optional<int> main_trials;  ///< at most so many; absent: all
  bool practice = true;
};

/// The participant's number: as given, else the digits that the name ends with ("P01" is 1). Throws
/// Error if there are none.
[[nodiscard]] int participant_number(const std::string& participant, std::optional<int> given);

[[nodiscard]] std::vector<protocols::PlannedTrial> shortened_plan(
    const protocols::ReadProtocol& read, protocols::SessionKey key, const Shortening& shortening);

/// The protocol's name beside the working folder: "words414.sqlite".
[[nodiscard]] std::filesystem::path default_data_file(const std::string& protocol_named);

/// Throws Error if the file already has this session of this participant and protocol, or if
/// somebody else of the same kind (people, simulated) has had the same number in it, and with it
/// the same lists, order and noise.
void refuse_repetition(const std::filesystem::path& data,
                       const std::string& participant,
                       protocols::SessionKey key,
                       const protocols::ReadProtocol& read,
                       bool simulated);

/// Who, what and with which program: all of a session's record but the devices.
[[nodiscard]] SessionRecord session_record(const protocols::ReadProtocol& read,
                                           const std::string& participant,
                                           protocols::SessionKey key);

[[nodiscard]] DeviceRecord record_of(const Display& display);
[[nodiscard]] DeviceRecord record_of(const AudioOutput& audio);

/// The plan as it is stored. Where a corpus speaks, the phones are those of its recording.
[[nodiscard]] std::vector<PlanRecord> plan_records(
    const protocols::ReadProtocol& read, const std::vector<protocols::PlannedTrial>& plan);

/// Now, as "2026-01-31T12:00:00Z".
[[nodiscard]] std::string utc_now();

}  // namespace bimodal::runner

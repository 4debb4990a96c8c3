#pragma once

#include <optional>

#include "protocols/model/protocol.hpp"
#include "runner/devices/audio_output.hpp"

namespace bimodal::runner {

/// The channels that the stimulus is heard on.
[[nodiscard]] ChannelSet stimulus_channels(const protocols::Sound& sound);

/// How many channels the output must have for the stimulus and the click; 0: the protocol names
/// none, and whatever there is of both ears will do.
[[nodiscard]] int channels_needed(const protocols::Protocol& protocol);

/// The click that a protocol asks for: a rectangular pulse (its length rounded to samples, at least
/// one) whose first sample leaves with that of the recording's time zero, which lies `sound_lead`
/// within the sound; absent if it asks for none.
[[nodiscard]] std::optional<Marker> click_marker(const protocols::Protocol& protocol,
                                                 Duration sound_lead);

}  // namespace bimodal::runner

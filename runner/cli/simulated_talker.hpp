#pragma once

#include <filesystem>

#include "runner/devices/simulated/simulated_input.hpp"

namespace bimodal::runner {

/// A microphone before which a recording is spoken: each stretch of speech in it is an utterance,
/// with 100 ms before and 150 ms after it; pauses of up to 300 ms belong to one. The room is the
/// longest stretch between them. Of several channels the mean is taken. Throws Error, naming the
/// file, if it cannot be read or nobody speaks in it.
[[nodiscard]] SimulatedInput::Options talker_of(const std::filesystem::path& recording, Hertz rate);

}  // namespace bimodal::runner

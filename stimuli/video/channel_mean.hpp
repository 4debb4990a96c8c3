#pragma once

#include <optional>
#include <vector>

#include "stimuli/video/libav.hpp"

namespace bimodal::libav {

/// Appends the mean of all channels of each sample of a decoded frame, in full-scale units:
/// integers are divided by 2^(bits - 1), floats kept. False if the sample format is none of
/// FFmpeg's.
[[nodiscard]] bool append_channel_mean(const AVFrame& frame, std::vector<float>& samples);

}  // namespace bimodal::libav

#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace bimodal::runner {

/// Where a photodiode's signal leaves its rest, in samples from the beginning of `signal`, to a
/// fraction: half-way between its level at rest (the median of the first `rest` samples) and the
/// extreme that it reaches, in either direction, if it then stays beyond half-way for `lasting`
/// samples. Absent if the step is smaller than 8 times the robust standard deviation at rest, or
/// than 0.002 of full scale.
[[nodiscard]] std::optional<double> onset_of_light(std::span<const float> signal,
                                                   std::size_t rest,
                                                   std::size_t lasting);

/// The first sample of a sound that begins at full level after silence (the first `rest` samples):
/// the first one whose magnitude is at least a third of the largest. Absent if that is smaller than
/// 8 times the robust standard deviation of the silence, or than 0.002 of full scale.
[[nodiscard]] std::optional<double> onset_of_sound(std::span<const float> signal, std::size_t rest);

}  // namespace bimodal::runner

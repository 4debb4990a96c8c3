#include "runner/devices/audio_output.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::runner {

Duration duration(const Sound& sound) {
  constexpr double kNanosecondsPerSecond = 1e9;
  std::size_t samples = sound.samples ? sound.samples->size() : 0;
  if (const auto& marker = sound.marker) {
    samples = std::max(samples, static_cast<std::size_t>(marker->start) + marker->samples->size());
  }
  return Duration{
      std::llround(static_cast<double>(samples) / sound.rate.count() * kNanosecondsPerSecond)};
}

void require_playable(const Sound& sound, Hertz output_rate) {
  if (!sound.samples) throw Error{"cannot play a sound that has no samples; prepare it first"};
  if (sound.rate == output_rate) return;
  throw Error{
      fmt::format("cannot play a sound of {} samples per second on an output of {}; mix it "
                  "at the output's rate",
                  sound.rate.count(),
                  output_rate.count())};
}

}  // namespace bimodal::runner

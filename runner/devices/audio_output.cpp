#include "runner/devices/audio_output.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

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

std::int64_t count_silent_head(const Sound& sound) {
  const auto& samples = *sound.samples;
  const auto first = std::ranges::find_if(samples, [](float sample) { return sample != 0.0F; });
  auto silent = std::min(first - samples.begin(), std::ssize(samples) - 1);
  if (sound.marker) silent = std::min(silent, sound.marker->start);
  return std::max<std::int64_t>(silent, 0);
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

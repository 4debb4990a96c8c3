#include "runner/devices/audio_output.hpp"

#include <cmath>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::runner {

Duration duration(const Sound& sound) {
  constexpr double kNanosecondsPerSecond = 1e9;
  const auto samples = static_cast<double>(sound.samples ? sound.samples->size() : 0);
  return Duration{std::llround(samples / sound.rate.count() * kNanosecondsPerSecond)};
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

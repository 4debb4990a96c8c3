#include "runner/calibration/calibration_sound.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "stimuli/audio/noise.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

constexpr Duration kRamp = std::chrono::milliseconds{50};

std::vector<float> tone(Hertz frequency, const CalibrationSound& sound, std::size_t length) {
  if (frequency.count() <= 0 || frequency.count() > sound.rate.count() / 2) {
    throw Error{fmt::format("a tone of {:g} Hz cannot be played at {:g} samples per second",
                            frequency.count(),
                            sound.rate.count())};
  }
  std::vector<float> samples(length);
  const double peak = std::numbers::sqrt2 * amplitude(sound.level);
  const double step = 2.0 * std::numbers::pi * frequency.count() / sound.rate.count();
  for (std::size_t i = 0; i < length; ++i) {
    samples[i] = static_cast<float>(peak * std::sin(step * static_cast<double>(i)));
  }
  return samples;
}

}  // namespace

Clip made(const CalibrationSound& sound) {
  const auto length = static_cast<std::size_t>(nearest_sample(sound.length, sound.rate).count());
  const auto ramp = static_cast<std::size_t>(nearest_sample(kRamp, sound.rate).count());
  Clip clip{.rate = sound.rate, .samples = {}};
  if (const auto* const band = std::get_if<Band>(&sound.content)) {
    require_band(*band, sound.rate);
    FourierTransform fourier;
    clip.samples = band_noise({.samples = length,
                               .rate = sound.rate,
                               .band = *band,
                               .level = sound.level,
                               .ramp = ramp,
                               .seed = 1},
                              fourier);
  } else {
    clip.samples = tone(std::get<Hertz>(sound.content), sound, length);
    apply_ramps(clip.samples, ramp);
  }
  const auto peak = std::ranges::max(clip.samples, {}, [](float x) { return std::abs(x); });
  if (std::abs(peak) > 1.0F) {
    throw Error{
        fmt::format("at {:g} dB FS it would clip (its peak is {:.2f} of full scale); play "
                    "it softer: levels go together dB by dB",
                    sound.level.count(),
                    std::abs(peak))};
  }
  return clip;
}

}  // namespace bimodal::runner

#include "stimuli/corpus/item_sound.hpp"

#include <algorithm>
#include <cmath>

#include "stimuli/audio/band.hpp"

namespace bimodal {

namespace {

constexpr float kFullScale = 0.99F;
constexpr std::size_t kShortestRun = 3;

/// The band, as far as the sampling rate goes.
Band speech_band(Hertz rate) {
  return {Hertz{80}, Hertz{std::min(8000.0, rate.count() / 2.0)}};
}

Decibels level_between(const Clip& sound, Duration start, Duration end, FourierTransform& fourier) {
  if (nearest_sample(end, sound.rate) <= nearest_sample(start, sound.rate)) return decibels(0.0);
  return band_level(cut(sound, {start, end}), sound.rate, speech_band(sound.rate), fourier);
}

}  // namespace

std::size_t clipped_runs(std::span<const float> samples) {
  std::size_t runs = 0;
  std::size_t length = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const bool is_full = std::abs(samples[i]) >= kFullScale;
    const bool goes_on = is_full && length > 0 && samples[i] == samples[i - 1];
    length = goes_on ? length + 1 : (is_full ? 1 : 0);
    if (length == kShortestRun) ++runs;
  }
  return runs;
}

ItemSound measure_item(const Clip& sound,
                       const SpeechInterval& item,
                       const SpeechInterval& speech,
                       FourierTransform& fourier) {
  return {.speech = band_level(cut(sound, speech), sound.rate, speech_band(sound.rate), fourier),
          .before = level_between(sound, item.start, speech.start, fourier),
          .after = level_between(sound, speech.end, std::min(item.end, sound.duration()), fourier),
          .clipped = clipped_runs(cut(sound, speech))};
}

}  // namespace bimodal

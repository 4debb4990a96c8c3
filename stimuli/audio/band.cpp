#include "stimuli/audio/band.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <numeric>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal {

void require_band(const Band& band, Hertz rate) {
  const bool ordered = band.low.count() >= 0.0 && band.low.count() < band.high.count();
  if (ordered && band.high.count() <= rate.count() / 2.0) return;
  throw Error{fmt::format(
      "cannot measure the band {} to {} Hz in sound of {} samples per second; choose "
      "edges in rising order, the upper at most half the sampling rate, or a higher rate",
      band.low.count(),
      band.high.count(),
      rate.count())};
}

Decibels level(std::span<const float> samples) {
  if (samples.empty()) return decibels(0.0);
  // Several sums side by side: one alone would wait for each addition to end before the next.
  constexpr std::size_t kSums = 8;
  std::array<double, kSums> squares{};
  const auto whole = samples.size() - samples.size() % kSums;
  for (std::size_t i = 0; i < whole; i += kSums) {
    for (std::size_t k = 0; k < kSums; ++k) {
      const auto sample = static_cast<double>(samples[i + k]);
      squares[k] += sample * sample;
    }
  }
  for (const float last : samples.subspan(whole)) {
    const auto sample = static_cast<double>(last);
    squares[0] += sample * sample;
  }
  const double sum = std::accumulate(squares.begin(), squares.end(), 0.0);
  return decibels(std::sqrt(sum / static_cast<double>(samples.size())));
}

Decibels band_level(std::span<const float> samples,
                    Hertz rate,
                    const Band& band,
                    FourierTransform& fourier) {
  require_band(band, rate);
  if (samples.empty()) return decibels(0.0);
  const auto bins = fourier.forward(samples);
  const std::size_t length = 2 * (bins.size() - 1);
  const double spacing = rate.count() / static_cast<double>(length);
  double squares = 0.0;
  for (std::size_t k = 0; k < bins.size(); ++k) {
    const double frequency = static_cast<double>(k) * spacing;
    if (frequency < band.low.count() || frequency > band.high.count()) continue;
    const bool has_mirror_image = k != 0 && k != length / 2;
    const std::complex<double> bin{bins[k]};
    squares += (has_mirror_image ? 2.0 : 1.0) * std::norm(bin);
  }
  return decibels(
      std::sqrt(squares / static_cast<double>(length) / static_cast<double>(samples.size())));
}

std::span<const float> cut(const Clip& sound, const SpeechInterval& interval) {
  const auto size = static_cast<std::int64_t>(sound.samples.size());
  const auto first = nearest_sample(interval.start, sound.rate).count();
  const auto last = nearest_sample(interval.end, sound.rate).count();
  if (first < 0 || last > size + 1 || first >= std::min(last, size)) {
    throw Error{fmt::format(
        "cannot take the interval {:.4f} to {:.4f} s out of a sound of {:.4f} s; give one that is "
        "not empty and lies within the sound",
        std::chrono::duration<double>{interval.start}.count(),
        std::chrono::duration<double>{interval.end}.count(),
        std::chrono::duration<double>{sound.duration()}.count())};
  }
  return std::span{sound.samples}.subspan(static_cast<std::size_t>(first),
                                          static_cast<std::size_t>(std::min(last, size) - first));
}

double amplitude(Decibels difference) {
  return std::pow(10.0, difference.count() / 20.0);
}

Decibels decibels(double amplitude) {
  return Decibels{20.0 * std::log10(amplitude)};
}

}  // namespace bimodal

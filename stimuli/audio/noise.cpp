#include "stimuli/audio/noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

/// The bins k of an N-point spectrum that get noise: first <= k < last.
struct Bins {
  std::size_t first;
  std::size_t last;
};

Bins bins_within(const Band& band, Hertz rate, std::size_t length) {
  const double bins_per_hertz = static_cast<double>(length) / rate.count();
  const auto lowest = static_cast<std::size_t>(std::ceil(band.low.count() * bins_per_hertz));
  const auto highest = static_cast<std::size_t>(std::floor(band.high.count() * bins_per_hertz));
  const Bins bins{std::max<std::size_t>(lowest, 1), std::min(highest + 1, length / 2)};
  if (bins.first >= bins.last) {
    throw Error{
        fmt::format("cannot make noise of {} samples between {} and {} Hz: so short a sound "
                    "has no component in so narrow a band; widen the band or lengthen the "
                    "sound",
                    length,
                    band.low.count(),
                    band.high.count())};
  }
  return bins;
}

}  // namespace

double raised_cosine(std::size_t index, std::size_t length) {
  const double phase = (static_cast<double>(index) + 0.5) / static_cast<double>(length);
  return 0.5 * (1.0 - std::cos(std::numbers::pi * phase));
}

void apply_ramps(std::span<float> samples, std::size_t ramp) {
  const auto length = std::min(ramp, samples.size() / 2);
  for (std::size_t i = 0; i < length; ++i) {
    const auto gain = static_cast<float>(raised_cosine(i, length));
    samples[i] *= gain;
    samples[samples.size() - 1 - i] *= gain;
  }
}

std::vector<float> band_noise(const NoiseRequest& request, FourierTransform& fourier) {
  require_band(request.band, request.rate);
  if (2 * request.ramp >= request.samples) {
    throw Error{
        fmt::format("cannot make noise of {} samples with ramps of {} samples at both ends: "
                    "nothing is left between them; shorten the ramps or lengthen the noise",
                    request.samples,
                    request.ramp)};
  }
  const auto length = common_fast_length(request.samples);
  const auto in_band = bins_within(request.band, request.rate, length);
  const auto spectrum = fourier.empty_spectrum(length);
  Random random{request.seed};
  for (std::size_t k = in_band.first; k < in_band.last; ++k) {
    const auto real = static_cast<float>(random.normal());
    const auto imaginary = static_cast<float>(random.normal());
    spectrum[k] = {real, imaginary};
  }
  const auto endless = fourier.inverse().first(request.samples);
  const auto steady = endless.subspan(request.ramp, request.samples - 2 * request.ramp);
  const auto gain = static_cast<float>(amplitude(request.level - level(steady)));
  std::vector<float> noise(endless.begin(), endless.end());
  for (auto& sample : noise) sample *= gain;
  apply_ramps(noise, request.ramp);
  return noise;
}

}  // namespace bimodal

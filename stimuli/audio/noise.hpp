#pragma once

#include <cstddef>
#include <vector>

#include "stimuli/audio/band.hpp"
#include "stimuli/audio/fourier.hpp"
#include "stimuli/base/quantity.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal {

struct NoiseRequest {
  std::size_t samples = 0;
  Hertz rate{48'000};
  Band band;
  Decibels level{};      ///< RMS of the steady part, dB re full scale (see band_level)
  std::size_t ramp = 0;  ///< samples of raised cosine at either end, outside the steady part
  Seed seed = 0;
};

/// White Gaussian noise limited to a band at any sampling rate, with raised-cosine ramps at both
/// ends.
///
/// Made in the frequency domain: of the N = common_fast_length(samples) point spectrum, every bin k
/// with low <= k rate / N <= high (less 0 and rate / 2) gets independent standard normal real and
/// imaginary parts, all others are zero; the first `samples` of the inverse transform are scaled so
/// that the RMS of the steady part (what lies between the ramps) is `level` exactly. Cutting out
/// spreads less than a ten-thousandth of the power beyond the band's edges, so that this is the
/// level in the band to 0.001 dB. The same request gives the same samples, bit for bit, on one
/// machine. Throws Error if the ramps leave no steady part or the band has no bin.
[[nodiscard]] std::vector<float> band_noise(const NoiseRequest& request, FourierTransform& fourier);

/// Half a period of a raised cosine, rising: (1 - cos(pi (index + 1/2) / length)) / 2.
[[nodiscard]] double raised_cosine(std::size_t index, std::size_t length);

/// Fades the samples in and out over `ramp` samples at either end (at most half of them).
void apply_ramps(std::span<float> samples, std::size_t ramp);

}  // namespace bimodal

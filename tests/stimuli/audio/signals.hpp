#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "stimuli/audio/clip.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal::testing_signals {

inline std::vector<float> sine(std::size_t samples, double rate, double frequency, double peak) {
  std::vector<float> made(samples);
  for (std::size_t n = 0; n < samples; ++n) {
    const double phase = 2.0 * std::numbers::pi * frequency * static_cast<double>(n) / rate;
    made[n] = static_cast<float>(peak * std::sin(phase));
  }
  return made;
}

/// Uniform in [-1, 1) by a generator that every language can repeat:
/// x = (1103515245 x + 12345) mod 2^31 from x = 1, sample = x / 2^30 - 1.
inline std::vector<float> repeatable(std::size_t samples) {
  std::vector<float> made(samples);
  std::uint64_t x = 1;
  for (auto& sample : made) {
    x = (1103515245U * x + 12345U) % (1ULL << 31U);
    sample = static_cast<float>(static_cast<double>(x) / static_cast<double>(1ULL << 30U) - 1.0);
  }
  return made;
}

/// |X(f)|^2 of the samples at one frequency, straight from the definition.
inline double power_at(std::span<const float> samples, double rate, double frequency) {
  const std::complex<double> step = std::polar(1.0, -2.0 * std::numbers::pi * frequency / rate);
  std::complex<double> turn{1.0};
  std::complex<double> sum{};
  for (const float sample : samples) {
    sum += static_cast<double>(sample) * turn;
    turn *= step;
  }
  return std::norm(sum);
}

inline double rms(std::span<const float> samples) {
  double squares = 0.0;
  for (const float sample : samples) {
    squares += static_cast<double>(sample) * static_cast<double>(sample);
  }
  return std::sqrt(squares / static_cast<double>(samples.size()));
}

inline double largest_difference(std::span<const float> a, std::span<const float> b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    largest = std::max(largest, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
  }
  return a.size() == b.size() ? largest : std::numeric_limits<double>::infinity();
}

}  // namespace bimodal::testing_signals

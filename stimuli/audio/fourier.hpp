#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace bimodal {

/// The smallest even number >= `samples` without prime factors above 5: a length that transforms
/// fast. At least 2.
[[nodiscard]] std::size_t fast_length(std::size_t samples);

/// The same, but above 16384 a multiple of 2048 too: one of few lengths, at most an eighth longer
/// than needed, so that the plan for it is soon found again.
[[nodiscard]] std::size_t common_fast_length(std::size_t samples);

/// Discrete Fourier transforms of real signals (kissfft, 32-bit float). A few plans, each for a
/// length and direction, are kept for the next time, because making one costs more than using it.
/// Used by one thread at a time; equal input gives equal output, bit for bit, on one machine.
class FourierTransform {
 public:
  FourierTransform();
  FourierTransform(const FourierTransform&) = delete;
  FourierTransform& operator=(const FourierTransform&) = delete;
  FourierTransform(FourierTransform&& other) noexcept;
  FourierTransform& operator=(FourierTransform&& other) noexcept;
  ~FourierTransform();

  /// X[k] = sum over n of x[n] exp(-2 pi i k n / N) for k = 0 ... N/2, N = fast_length(signal
  /// size), the signal followed by zeros. The span is valid until the next call.
  [[nodiscard]] std::span<const std::complex<float>> forward(std::span<const float> signal);

  /// The bins 0 ... N/2 of a spectrum of N points, all zero, to be filled and given to inverse().
  /// N must be a fast_length. Valid until the next call of anything but inverse().
  [[nodiscard]] std::span<std::complex<float>> empty_spectrum(std::size_t length);

  /// x[n] = sum over all N bins of X[k] exp(2 pi i k n / N), the upper half being the complex
  /// conjugate of the bins 0 ... N/2 of the spectrum (not divided by N); the imaginary parts of the
  /// first and the last bin are taken as 0. Valid until the next call.
  [[nodiscard]] std::span<float> inverse();

 private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

}  // namespace bimodal

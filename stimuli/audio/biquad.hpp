#pragma once

#include "stimuli/base/quantity.hpp"

namespace bimodal {

/// A Butterworth filter of second order (12 dB an octave, 3 dB down at its edge), by the bilinear
/// transform with the edge prewarped; transposed direct form II.
class Biquad {
 public:
  /// 0 < edge < rate / 2.
  [[nodiscard]] static Biquad low_pass(Hertz edge, Hertz rate) { return {edge, rate, false}; }

  [[nodiscard]] static Biquad high_pass(Hertz edge, Hertz rate) { return {edge, rate, true}; }

  /// As if a first sample had been there for ever: its offset gives no step.
  void settle(double in);

  /// The next sample of the filtered sound.
  double operator()(double in) {
    const double out = b0_ * in + first_;
    first_ = b1_ * in - a1_ * out + second_;
    second_ = b0_ * in - a2_ * out;
    return out;
  }

 private:
  Biquad(Hertz edge, Hertz rate, bool high);

  double b0_ = 0.0;  ///< and b2
  double b1_ = 0.0;
  double a1_ = 0.0;
  double a2_ = 0.0;
  double first_ = 0.0;
  double second_ = 0.0;
};

}  // namespace bimodal

#include "stimuli/audio/biquad.hpp"

#include <cmath>
#include <numbers>

namespace bimodal {

Biquad::Biquad(Hertz edge, Hertz rate, bool high) {
  const double k = std::tan(std::numbers::pi * edge.count() / rate.count());
  const double norm = 1.0 / (1.0 + std::numbers::sqrt2 * k + k * k);
  b0_ = high ? norm : k * k * norm;
  b1_ = high ? -2.0 * b0_ : 2.0 * b0_;
  a1_ = 2.0 * (k * k - 1.0) * norm;
  a2_ = (1.0 - std::numbers::sqrt2 * k + k * k) * norm;
}

void Biquad::settle(double in) {
  const double gain = (2.0 * b0_ + b1_) / (1.0 + a1_ + a2_);  // of a constant
  const double out = gain * in;
  second_ = b0_ * in - a2_ * out;
  first_ = out - b0_ * in;
}

}  // namespace bimodal

#include "synth/face/dental_arch.hpp"

#include <algorithm>
#include <cmath>

namespace bimodal::synth {

namespace {
constexpr double kExponent = 2.7;
}  // namespace

double DentalArch::z_at(double x) const {
  return incisor_z - depth * std::pow(std::abs(x) / half_width, kExponent);
}

double DentalArch::half_width_at(double z) const {
  return half_width * std::pow(std::max(0.0, incisor_z - z) / depth, 1.0 / kExponent);
}

}  // namespace bimodal::synth

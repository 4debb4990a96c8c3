#pragma once

namespace bimodal::synth {

/// The labial face of a row of teeth seen from above: z = incisor_z - depth (|x| / half_width)^2.7,
/// mm.
struct DentalArch {
  double incisor_z;
  double half_width;
  double depth;

  [[nodiscard]] double z_at(double x) const;

  /// The half width at which the arch has come back to z; 0 in front of the incisors.
  [[nodiscard]] double half_width_at(double z) const;
};

inline constexpr DentalArch kUpperArch{.incisor_z = 93.0, .half_width = 26.0, .depth = 28.0};
inline constexpr DentalArch kLowerArch{.incisor_z = 90.0, .half_width = 24.5, .depth = 27.0};

}  // namespace bimodal::synth

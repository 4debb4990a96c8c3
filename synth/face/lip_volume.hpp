#pragma once

#include <array>
#include <span>

#include <glm/vec3.hpp>

#include "synth/face/mouth_loops.hpp"

namespace bimodal::synth {

/// Lips are flesh: what they lose in length they gain in thickness. Each section of a lip, from the
/// white roll over the vermilion to the inside, keeps the volume that it has at rest: the fullest
/// vermilion swells or flattens, level and across the lip, by at most 1.8 mm; the strip where the
/// lips touch stays where it is.
class LipVolume {
 public:
  /// `rest`: the skin cage at rest, mm.
  LipVolume(const MouthLoops& mouth, std::span<const glm::dvec3> rest);

  void keep(const MouthLoops& mouth, std::span<glm::dvec3> skin) const;

 private:
  /// By which each section swells, mm, from the upper midline to the lower.
  using Swelling = std::array<glm::dvec3, MouthLoops::kColumns>;

  [[nodiscard]] Swelling swelling(const MouthLoops& mouth,
                                  MouthLoops::Side side,
                                  std::span<const glm::dvec3> skin) const;

  std::array<double, MouthLoops::kColumns> rest_volume_{};  ///< mm3, of sections of the left side
};

}  // namespace bimodal::synth

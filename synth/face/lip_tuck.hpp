#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/field_table.hpp"
#include "synth/face/mouth_loops.hpp"

namespace bimodal::synth {

/// The lower lip of /f/ and /v/: rolled back over its own border, then, after the jaw has moved,
/// carried to the edge of the upper incisors wherever the jaw is.
class LipTuck {
 public:
  LipTuck(const FieldTable& table, std::span<const glm::dvec3> rest);

  /// Before the jaw. `tuck` 0 to 1.
  void roll(double tuck, std::span<glm::dvec3> skin) const;

  /// After the jaw.
  void carry(double tuck, const MouthLoops& mouth, std::span<glm::dvec3> skin) const;

 private:
  struct Rolled {
    std::size_t vertex;
    double weight;
    double axis_y;
    double axis_z;
  };

  std::vector<Rolled> rolled_;
  std::vector<double> weight_;
};

}  // namespace bimodal::synth

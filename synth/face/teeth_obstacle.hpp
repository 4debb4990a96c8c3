#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/field_table.hpp"
#include "synth/face/jaw.hpp"

namespace bimodal::synth {

/// Keeps the inside of the lips (rings 6 to 9) in front of the teeth: all of it before the upper
/// arch, the lower lip also before the lower arch wherever the jaw has taken that.
class TeethObstacle {
 public:
  explicit TeethObstacle(const FieldTable& table);

  void push_lips_out(const JawMotion& jaw, std::span<glm::dvec3> skin) const;

 private:
  struct Inside {
    std::size_t vertex;
    bool lower;
  };

  std::vector<Inside> inside_;
};

}  // namespace bimodal::synth

#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "synth/face/field_table.hpp"
#include "synth/speech/control.hpp"

namespace bimodal::synth {

/// What the lip, cheek and brow controls add to the skin cage, each control times its displacement
/// field; and what opening the jaw drags along in the lips before it turns.
class LinearFields {
 public:
  explicit LinearFields(const FieldTable& table);

  void move(const Pose& pose, std::span<glm::dvec3> skin) const;

 private:
  struct Field {
    Control control;
    std::vector<glm::dvec3> per_unit;
  };

  std::vector<Field> fields_;
  std::vector<glm::dvec3> width_;       ///< per mm at one corner, spreading
  std::vector<glm::dvec3> narrow_;      ///< the same, narrowing
  std::vector<glm::dvec3> width_thin_;  ///< per mm of mouth width: spread lips become thin
  std::vector<glm::dvec3> jaw_drag_;    ///< per degree of jaw opening
};

}  // namespace bimodal::synth

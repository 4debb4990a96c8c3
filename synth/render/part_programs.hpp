#pragma once

#include <vector>

#include <glm/mat3x3.hpp>

#include "synth/face/surface.hpp"
#include "synth/render/appearance.hpp"
#include "synth/render/camera.hpp"
#include "synth/render/shader.hpp"

namespace bimodal::synth {

/// Whether what lies in the mouth is seen though the lips may be shut.
[[nodiscard]] bool shows_inside(const Appearance& appearance);

/// One program for each part of the head, for one appearance and camera. They live as long as the
/// context that is current at construction.
class PartPrograms {
 public:
  /// `map_from_world`: that of the shadow map, which full quality wants in texture unit 0.
  PartPrograms(const Appearance& appearance, const Camera& camera, const glm::mat4& map_from_world);

  /// Whether the part is to be drawn at all: it is shown, or bare skin stands in its place.
  [[nodiscard]] bool draws(HeadPart part) const { return has(drawn_, part); }

  /// The parts that throw shadows: not skin that one sees through, or that is cut away.
  [[nodiscard]] const PartSet& casters() const { return casters_; }

  /// The pose of what is drawn from now on.
  void follow(const LipMeasures& lips, const glm::mat3& head_axes) const;

  void use(HeadPart part) const { programs_[static_cast<std::size_t>(part)].use(); }

 private:
  PartSet drawn_;
  PartSet casters_;
  std::vector<Program> programs_;  // one per HeadPart
};

}  // namespace bimodal::synth

#pragma once

#include <array>
#include <span>
#include <vector>

#include <epoxy/gl.h>

#include "synth/face/surface.hpp"
#include "synth/render/appearance.hpp"
#include "synth/render/outline.hpp"
#include "synth/render/shader.hpp"

namespace bimodal::synth {

/// The faces that a plane leaves where it cuts the head: skin, gums, teeth and tongue, each filled
/// with its own colour and outlined. The lines in which a surface meets the plane are joined to
/// outlines; what they enclose is filled by
/// winding number, in the stencil buffer: parts may overlap, and the mouth stays open. Objects live
/// as long as the context that is current at construction.
class CutFaces {
 public:
  /// `shown`: only what is drawn is cut. The descriptions are borrowed.
  CutFaces(std::span<const SurfaceDescription> surfaces,
           const Plane& plane,
           const Materials& materials,
           const PartSet& shown,
           const glm::mat4& clip_from_world);

  /// After everything opaque; needs an empty stencil buffer and leaves it empty.
  void draw(const PosedHead& posed);

 private:
  enum class Kind : std::uint8_t { Skin, Gums, Teeth, Tongue };
  static constexpr std::size_t kKinds = 4;

  void collect(const PosedHead& posed);
  void draw_kind(std::size_t kind) const;
  void fill(std::span<const glm::vec3> corners, const glm::vec3& colour) const;
  void send(std::span<const glm::vec3> corners) const;
  [[nodiscard]] static bool kind_of(const SurfaceDescription& surface,
                                    const PartSet& shown,
                                    Kind& kind);

  std::span<const SurfaceDescription> surfaces_;
  glm::vec3 normal_;
  float distance_;
  PartSet shown_;
  std::array<glm::vec3, kKinds + 1> colours_;  // of each kind, and of the outline
  std::array<std::vector<Outline>, kKinds> outlines_;
  std::array<std::vector<std::vector<glm::vec3>>, kKinds> polygons_;  // what they enclose
  Program program_;
  GLuint vertex_array_ = 0;
  GLuint buffer_ = 0;
};

}  // namespace bimodal::synth

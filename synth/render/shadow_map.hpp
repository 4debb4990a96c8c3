#pragma once

#include <epoxy/gl.h>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "synth/render/head_part.hpp"
#include "synth/render/mesh_buffers.hpp"
#include "synth/render/shader.hpp"

namespace bimodal::synth {

/// What the key light reaches of the head as it stands now: the depths of what it meets first.
/// Lives as long as the context that is current at construction.
class ShadowMap {
 public:
  /// `towards`: the way to the light, unit length.
  explicit ShadowMap(const glm::vec3& towards);

  /// Draws the map anew from the parts that are opaque; leaves its own framebuffer
  /// current and the map in texture unit 0.
  void draw(const MeshBuffers& mesh, const PartSet& casters) const;

  /// To where in the map a point is, 0..1 each way, and how deep.
  [[nodiscard]] const glm::mat4& map_from_world() const { return map_from_world_; }

 private:
  glm::mat4 clip_from_world_{1.0F};
  glm::mat4 map_from_world_{1.0F};
  Program program_;
  GLuint texture_ = 0;
  GLuint framebuffer_ = 0;
};

}  // namespace bimodal::synth

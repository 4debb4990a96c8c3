#pragma once

#include <span>
#include <vector>

#include <epoxy/gl.h>
#include <glm/vec3.hpp>

#include "synth/face/surface.hpp"
#include "synth/render/appearance.hpp"
#include "synth/render/camera.hpp"
#include "synth/render/shader.hpp"
#include "synth/render/view.hpp"

namespace bimodal::synth {

/// A vertex of one of the head's surfaces.
struct SurfaceVertex {
  std::size_t surface = 0;
  std::size_t vertex = 0;
};

/// The vertices that shine. Sparse: the nearest at rest to 28 places of ours, after the kind of
/// places of Rosenblum, Johnson & Saldana (1996, Journal of Speech and Hearing Research 39).
[[nodiscard]] std::vector<SurfaceVertex> shining_vertices(
    std::span<const SurfaceDescription> surfaces, Points points);

/// Round spots of one colour on vertices. Objects live as long as the context that is current at
/// construction.
class LightPoints {
 public:
  LightPoints(std::span<const SurfaceDescription> surfaces,
              const Appearance& appearance,
              const View& view,
              const Camera& camera);

  /// What hides them must be in the depth buffer.
  void draw(const PosedHead& posed);

 private:
  std::vector<SurfaceVertex> vertices_;
  glm::vec3 camera_;
  Program program_;
  std::vector<glm::vec3> positions_;
  GLuint vertex_array_ = 0;
  GLuint buffer_ = 0;
};

}  // namespace bimodal::synth

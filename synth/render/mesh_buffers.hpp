#pragma once

#include <array>
#include <span>
#include <vector>

#include <epoxy/gl.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "synth/face/surface.hpp"
#include "synth/render/drawn_mesh.hpp"

namespace bimodal::synth {

/// What never changes about a vertex; the attributes 2-7 of head.vert.
struct FixedVertex {
  glm::vec3 rest;
  glm::vec3 albedo;
  glm::vec4 baked;  ///< open sky, key light, fill light at rest; inside the mouth
  glm::vec4 masks;  ///< lip, wet, scalp, special
  glm::vec3 brow;
  glm::vec2 gloss;
};

/// The head on the graphics device. Only positions and normals travel with every frame. Objects
/// live as long as the context that is current at construction.
class MeshBuffers {
 public:
  explicit MeshBuffers(const DrawnMesh& mesh);

  /// One per drawn vertex; sent once.
  void fix(std::span<const FixedVertex> vertices) const;

  void move_to(const PosedHead& posed) const;

  enum class Side : std::uint8_t { Near, Both };

  /// Draws the triangles of one part with the program in use.
  void draw(HeadPart part, Side side) const;

 private:
  struct Range {
    std::size_t first = 0;
    std::size_t near_count = 0;
    std::size_t count = 0;
  };

  std::vector<DrawnVertex> vertices_;
  std::array<Range, kHeadPartCount> ranges_{};
  GLuint vertex_array_ = 0;
  GLuint moving_ = 0;
  GLuint fixed_ = 0;
};

}  // namespace bimodal::synth

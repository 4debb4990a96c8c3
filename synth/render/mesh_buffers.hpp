#pragma once

#include <array>
#include <span>
#include <vector>

#include <epoxy/gl.h>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "synth/face/surface.hpp"
#include "synth/render/head_parts.hpp"

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
  MeshBuffers(std::span<const SurfaceDescription> surfaces,
              std::span<const PartTriangles, kHeadPartCount> triangles);

  /// One per vertex, through all surfaces; sent once.
  void fix(std::span<const FixedVertex> vertices) const;

  /// `posed` has as many surfaces and vertices as the descriptions (asserted).
  void move_to(const PosedHead& posed) const;

  enum class Side : std::uint8_t { Near, Both };

  /// Draws the triangles of one part with the program in use.
  void draw(HeadPart part, Side side) const;

  [[nodiscard]] std::size_t vertex_count() const { return vertex_count_; }

 private:
  struct Range {
    std::size_t first = 0;
    std::size_t near_count = 0;
    std::size_t count = 0;
  };

  std::vector<std::size_t> surface_sizes_;  // vertices
  std::size_t vertex_count_ = 0;
  std::array<Range, kHeadPartCount> ranges_{};
  GLuint vertex_array_ = 0;
  GLuint positions_ = 0;
  GLuint normals_ = 0;
  GLuint fixed_ = 0;
};

}  // namespace bimodal::synth

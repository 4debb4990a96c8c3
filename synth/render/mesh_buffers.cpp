#include "synth/render/mesh_buffers.hpp"

#include <cassert>
#include <cstddef>
#include <cstdint>

#include "stimuli/base/error.hpp"

namespace bimodal::synth {

namespace {

/// What travels with every frame; the attributes 0 and 1 of head.vert.
struct MovingVertex {
  glm::vec3 position;
  glm::vec3 normal;
};

GLuint new_buffer() {
  GLuint name = 0;
  glGenBuffers(1, &name);
  return name;
}

void describe_attribute(GLuint slot, GLint components, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(slot);
  glVertexAttribPointer(slot,
                        components,
                        GL_FLOAT,
                        GL_FALSE,
                        static_cast<GLsizei>(stride),
                        reinterpret_cast<const void*>(offset));
}

void describe_moving_attributes() {
  constexpr std::size_t kStride = sizeof(MovingVertex);
  describe_attribute(0, 3, kStride, offsetof(MovingVertex, position));
  describe_attribute(1, 3, kStride, offsetof(MovingVertex, normal));
}

void describe_fixed_attributes() {
  constexpr std::size_t kStride = sizeof(FixedVertex);
  describe_attribute(2, 3, kStride, offsetof(FixedVertex, rest));
  describe_attribute(3, 3, kStride, offsetof(FixedVertex, albedo));
  describe_attribute(4, 4, kStride, offsetof(FixedVertex, baked));
  describe_attribute(5, 4, kStride, offsetof(FixedVertex, masks));
  describe_attribute(6, 3, kStride, offsetof(FixedVertex, brow));
  describe_attribute(7, 2, kStride, offsetof(FixedVertex, gloss));
}

}  // namespace

MeshBuffers::MeshBuffers(const DrawnMesh& mesh)
    : vertices_{mesh.vertices}, moving_{new_buffer()}, fixed_{new_buffer()} {
  std::vector<std::uint32_t> indices;
  for (std::size_t part = 0; part < kHeadPartCount; ++part) {
    const PartTriangles& own = mesh.parts.at(part);
    ranges_.at(part) = {indices.size(), own.near.size(), own.near.size() + own.far.size()};
    indices.insert(indices.end(), own.near.begin(), own.near.end());
    indices.insert(indices.end(), own.far.begin(), own.far.end());
  }

  glGenVertexArrays(1, &vertex_array_);
  glBindVertexArray(vertex_array_);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, new_buffer());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
               indices.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, moving_);
  describe_moving_attributes();
  glBindBuffer(GL_ARRAY_BUFFER, fixed_);
  describe_fixed_attributes();
  fix(std::vector<FixedVertex>(vertices_.size()));
}

void MeshBuffers::fix(std::span<const FixedVertex> vertices) const {
  assert(vertices.size() == vertices_.size());
  glBindBuffer(GL_ARRAY_BUFFER, fixed_);
  glBufferData(GL_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(vertices.size_bytes()),
               vertices.data(),
               GL_STATIC_DRAW);
}

/// The buffer gets fresh memory, so that the device need not wait for the frame before.
void MeshBuffers::move_to(const PosedHead& posed) const {
  const auto bytes = static_cast<GLsizeiptr>(vertices_.size() * sizeof(MovingVertex));
  glBindBuffer(GL_ARRAY_BUFFER, moving_);
  glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_STREAM_DRAW);
  auto* sent = static_cast<MovingVertex*>(
      glMapBufferRange(GL_ARRAY_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT));
  if (sent == nullptr) throw Error{"cannot move the head: OpenGL gives no memory for it"};
  for (const auto& [surface, own] : vertices_) {
    const SurfaceGeometry& geometry = posed.surfaces[surface];
    *sent++ = {geometry.positions[own], geometry.normals[own]};
  }
  glUnmapBuffer(GL_ARRAY_BUFFER);
}

void MeshBuffers::draw(HeadPart part, Side side) const {
  const Range& range = ranges_.at(static_cast<std::size_t>(part));
  const std::size_t count = side == Side::Near ? range.near_count : range.count;
  if (count == 0) return;
  glBindVertexArray(vertex_array_);
  glDrawElements(GL_TRIANGLES,
                 static_cast<GLsizei>(count),
                 GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(range.first * sizeof(std::uint32_t)));
}

}  // namespace bimodal::synth

#include "synth/render/mesh_buffers.hpp"

#include <cassert>
#include <cstddef>
#include <cstdint>

namespace bimodal::synth {

namespace {

constexpr GLuint kPositionSlot = 0;
constexpr GLuint kNormalSlot = 1;

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

void describe_fixed_attributes() {
  constexpr std::size_t kStride = sizeof(FixedVertex);
  describe_attribute(2, 3, kStride, offsetof(FixedVertex, rest));
  describe_attribute(3, 3, kStride, offsetof(FixedVertex, albedo));
  describe_attribute(4, 4, kStride, offsetof(FixedVertex, baked));
  describe_attribute(5, 4, kStride, offsetof(FixedVertex, masks));
  describe_attribute(6, 3, kStride, offsetof(FixedVertex, brow));
  describe_attribute(7, 2, kStride, offsetof(FixedVertex, gloss));
}

/// Gives the buffer fresh memory, so that the device need not wait for the frame before.
void renew(GLuint buffer, std::size_t bytes) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STREAM_DRAW);
}

}  // namespace

MeshBuffers::MeshBuffers(std::span<const SurfaceDescription> surfaces,
                         std::span<const PartTriangles, kHeadPartCount> triangles)
    : positions_{new_buffer()}, normals_{new_buffer()}, fixed_{new_buffer()} {
  for (const SurfaceDescription& surface : surfaces) {
    surface_sizes_.push_back(surface.rest_positions.size());
    vertex_count_ += surface.rest_positions.size();
  }
  std::vector<std::uint32_t> indices;
  for (std::size_t part = 0; part < kHeadPartCount; ++part) {
    const PartTriangles& own = triangles[part];
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
  glBindBuffer(GL_ARRAY_BUFFER, positions_);
  describe_attribute(kPositionSlot, 3, sizeof(glm::vec3), 0);
  glBindBuffer(GL_ARRAY_BUFFER, normals_);
  describe_attribute(kNormalSlot, 3, sizeof(glm::vec3), 0);
  glBindBuffer(GL_ARRAY_BUFFER, fixed_);
  describe_fixed_attributes();
  fix(std::vector<FixedVertex>(vertex_count_));
}

void MeshBuffers::fix(std::span<const FixedVertex> vertices) const {
  assert(vertices.size() == vertex_count_);
  glBindBuffer(GL_ARRAY_BUFFER, fixed_);
  glBufferData(GL_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(vertices.size_bytes()),
               vertices.data(),
               GL_STATIC_DRAW);
}

void MeshBuffers::move_to(const PosedHead& posed) const {
  assert(posed.surfaces.size() == surface_sizes_.size());
  const auto send = [&](GLuint buffer, auto member) {
    renew(buffer, vertex_count_ * sizeof(glm::vec3));
    std::size_t offset = 0;
    for (std::size_t s = 0; s < posed.surfaces.size(); ++s) {
      const std::vector<glm::vec3>& values = posed.surfaces[s].*member;
      assert(values.size() == surface_sizes_[s]);
      const std::size_t bytes = values.size() * sizeof(glm::vec3);
      glBufferSubData(GL_ARRAY_BUFFER,
                      static_cast<GLintptr>(offset),
                      static_cast<GLsizeiptr>(bytes),
                      values.data());
      offset += bytes;
    }
  };
  send(positions_, &SurfaceGeometry::positions);
  send(normals_, &SurfaceGeometry::normals);
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

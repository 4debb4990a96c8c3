#include "synth/face/stencils.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::synth {

namespace {

using Mesh = OpenMesh::PolyMesh_ArrayKernelT<>;
using Row = std::vector<std::pair<std::uint32_t, double>>;  ///< cage vertex -> weight, in order

/// Adds up rows.
class RowSum {
 public:
  explicit RowSum(std::size_t cage_size) : weight_(cage_size) {}

  void add(const Row& row, double weight) {
    if (weight == 0.0) return;
    for (const auto& [vertex, value] : row) {
      if (weight_[vertex] == 0.0) touched_.push_back(vertex);
      weight_[vertex] += weight * value;
    }
  }

  /// The sum so far; starts anew.
  Row take() {
    std::ranges::sort(touched_);
    Row row;
    row.reserve(touched_.size());
    for (const auto vertex : touched_) {
      row.emplace_back(vertex, std::exchange(weight_[vertex], 0.0));
    }
    touched_.clear();
    return row;
  }

 private:
  std::vector<double> weight_;
  std::vector<std::uint32_t> touched_;
};

std::size_t at(const OpenMesh::BaseHandle& element) {
  return static_cast<std::size_t>(element.idx());
}

Mesh mesh_of(std::size_t vertices, std::span<const Face> faces) {
  Mesh mesh;
  std::vector<Mesh::VertexHandle> handles(vertices);
  for (auto& handle : handles) handle = Mesh::VertexHandle{mesh.add_vertex({0, 0, 0}).idx()};
  for (std::size_t i = 0; i < faces.size(); ++i) {
    std::vector<Mesh::VertexHandle> corners;
    for (const auto vertex : faces[i]) corners.push_back(handles.at(vertex));
    if (!mesh.add_face(corners).is_valid()) {
      throw Error{
          fmt::format("cannot subdivide the mesh: face {} (from 0) does not fit a surface", i)};
    }
  }
  return mesh;
}

std::vector<Row> face_points(const Mesh& mesh, const std::vector<Row>& rows, RowSum& sum) {
  std::vector<Row> points(mesh.n_faces());
  for (const auto face : mesh.faces()) {
    for (const auto vertex : face.vertices()) sum.add(rows[at(vertex)], 1.0 / face.valence());
    points[at(face)] = sum.take();
  }
  return points;
}

std::vector<Row> midpoints(const Mesh& mesh, const std::vector<Row>& rows, RowSum& sum) {
  std::vector<Row> points(mesh.n_edges());
  for (const auto edge : mesh.edges()) {
    sum.add(rows[at(edge.v0())], 0.5);
    sum.add(rows[at(edge.v1())], 0.5);
    points[at(edge)] = sum.take();
  }
  return points;
}

std::vector<Row> edge_points(const Mesh& mesh,
                             const std::vector<Row>& of_midpoints,
                             const std::vector<Row>& of_faces,
                             RowSum& sum) {
  std::vector<Row> points(mesh.n_edges());
  for (const auto edge : mesh.edges()) {
    if (edge.is_boundary()) {
      points[at(edge)] = of_midpoints[at(edge)];
      continue;
    }
    sum.add(of_midpoints[at(edge)], 0.5);
    sum.add(of_faces[at(edge.h0().face())], 0.25);
    sum.add(of_faces[at(edge.h1().face())], 0.25);
    points[at(edge)] = sum.take();
  }
  return points;
}

std::vector<Row> vertex_points(const Mesh& mesh,
                               const std::vector<Row>& rows,
                               const std::vector<Row>& of_midpoints,
                               const std::vector<Row>& of_faces,
                               RowSum& sum) {
  std::vector<Row> points(mesh.n_vertices());
  for (const auto vertex : mesh.vertices()) {
    const double valence = vertex.valence();
    if (vertex.is_boundary()) {
      sum.add(rows[at(vertex)], 0.5);
      for (const auto edge : vertex.edges()) {
        if (edge.is_boundary()) sum.add(of_midpoints[at(edge)], 0.25);
      }
    } else {
      sum.add(rows[at(vertex)], (valence - 3.0) / valence);
      for (const auto face : vertex.faces()) {
        sum.add(of_faces[at(face)], 1.0 / (valence * valence));
      }
      for (const auto edge : vertex.edges()) {
        sum.add(of_midpoints[at(edge)], 2.0 / (valence * valence));
      }
    }
    points[at(vertex)] = sum.take();
  }
  return points;
}

/// The refined topology: vertices first, then edges, then faces of `mesh`.
std::vector<Face> refined_faces(const Mesh& mesh) {
  const auto vertices = mesh.n_vertices();
  const auto before_faces = vertices + mesh.n_edges();
  std::vector<Face> quads;
  for (const auto face : mesh.faces()) {
    for (const auto halfedge : face.halfedges()) {
      quads.push_back({static_cast<std::uint32_t>(at(halfedge.to())),
                       static_cast<std::uint32_t>(vertices + at(halfedge.next().edge())),
                       static_cast<std::uint32_t>(before_faces + at(face)),
                       static_cast<std::uint32_t>(vertices + at(halfedge.edge()))});
    }
  }
  return quads;
}

/// One step: `rows` are the stencils of the vertices of `faces`; both are refined.
void refine(std::vector<Row>& rows, std::vector<Face>& faces, RowSum& sum) {
  const Mesh mesh = mesh_of(rows.size(), faces);
  const auto of_faces = face_points(mesh, rows, sum);
  const auto of_midpoints = midpoints(mesh, rows, sum);
  const auto of_edges = edge_points(mesh, of_midpoints, of_faces, sum);
  rows = vertex_points(mesh, rows, of_midpoints, of_faces, sum);
  rows.insert(rows.end(), of_edges.begin(), of_edges.end());
  rows.insert(rows.end(), of_faces.begin(), of_faces.end());
  faces = refined_faces(mesh);
}

}  // namespace

Stencils::Stencils(std::size_t cage_size, std::span<const Face> faces, int levels)
    : cage_size_{cage_size} {
  std::vector<Row> rows(cage_size);
  for (std::size_t i = 0; i < cage_size; ++i) rows[i] = {{static_cast<std::uint32_t>(i), 1.0}};
  std::vector<Face> fine_faces{faces.begin(), faces.end()};
  assert(levels >= 1);
  RowSum sum{cage_size};
  for (int level = 0; level < levels; ++level) refine(rows, fine_faces, sum);

  first_.push_back(0);
  for (const auto& row : rows) {
    for (const auto& [vertex, weight] : row) {
      column_.push_back(vertex);
      weight_.push_back(weight);
    }
    first_.push_back(static_cast<std::uint32_t>(column_.size()));
  }
  for (const auto& face : fine_faces) quads_.push_back({face[0], face[1], face[2], face[3]});
  sort_terms();
}

void Stencils::sort_terms() {
  by_length_.resize(fine_size());
  std::iota(by_length_.begin(), by_length_.end(), 0U);
  std::ranges::stable_sort(
      by_length_, {}, [this](auto row) { return first_[row + 1] - first_[row]; });
  for (const auto row : by_length_) {
    for (auto i = first_[row]; i < first_[row + 1]; ++i) {
      terms_.push_back({.column = column_[i], .weight = static_cast<float>(weight_[i])});
    }
  }
}

glm::dvec3 Stencils::point(std::span<const glm::dvec3> cage, std::size_t fine_vertex) const {
  glm::dvec3 sum{0.0};
  for (auto i = first_[fine_vertex]; i < first_[fine_vertex + 1]; ++i) {
    sum += weight_[i] * cage[column_[i]];
  }
  return sum;
}

void Stencils::apply(std::span<const glm::dvec3> cage, std::vector<glm::vec3>& fine) const {
  assert(cage.size() == cage_size_);
  fine.resize(fine_size());
  for (std::size_t i = 0; i < fine.size(); ++i) fine[i] = glm::vec3{point(cage, i)};
}

void Stencils::apply(std::span<const Padded> cage, PaddedPoints& fine) const {
  assert(cage.size() == cage_size_);
  fine.resize(fine_size());
  auto term = terms_.begin();
  for (const auto row : by_length_) {
    Padded sum{};
    for (const auto end = term + (first_[row + 1] - first_[row]); term != end; ++term) {
      sum += term->weight * cage[term->column];
    }
    fine[row] = sum;
  }
}

std::vector<float> Stencils::apply(std::span<const double> cage) const {
  assert(cage.size() == cage_size_);
  std::vector<float> fine(fine_size());
  for (std::size_t row = 0; row < fine.size(); ++row) {
    double sum = 0.0;
    for (auto i = first_[row]; i < first_[row + 1]; ++i) sum += weight_[i] * cage[column_[i]];
    fine[row] = static_cast<float>(sum);
  }
  return fine;
}

std::vector<std::uint32_t> Stencils::triangles() const {
  std::vector<std::uint32_t> result;
  result.reserve(quads_.size() * 6);
  for (const auto& [a, b, c, d] : quads_) result.insert(result.end(), {a, b, c, a, c, d});
  return result;
}

}  // namespace bimodal::synth

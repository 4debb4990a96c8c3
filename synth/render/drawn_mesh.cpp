#include "synth/render/drawn_mesh.hpp"

#include <limits>

namespace bimodal::synth {

namespace {

std::vector<DrawnVertex> all_vertices(std::span<const SurfaceDescription> surfaces) {
  std::vector<DrawnVertex> vertices;
  for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
    const auto count = static_cast<std::uint32_t>(surfaces[s].rest_positions.size());
    for (std::uint32_t own = 0; own < count; ++own) vertices.push_back({s, own});
  }
  return vertices;
}

/// Gives vertices new numbers, in the order in which it meets them.
class Numbering {
 public:
  explicit Numbering(std::vector<DrawnVertex> all)
      : all_{std::move(all)}, new_number_(all_.size(), kNone) {}

  void renumber(std::vector<std::uint32_t>& indices) {
    for (std::uint32_t& index : indices) {
      std::uint32_t& number = new_number_[index];
      if (number == kNone) {
        number = static_cast<std::uint32_t>(met_.size());
        met_.push_back(all_[index]);
      }
      index = number;
    }
  }

  [[nodiscard]] std::vector<DrawnVertex> met() && { return std::move(met_); }

 private:
  static constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();

  std::vector<DrawnVertex> all_;
  std::vector<std::uint32_t> new_number_;
  std::vector<DrawnVertex> met_;
};

}  // namespace

DrawnMesh drawn_mesh(std::span<const SurfaceDescription> surfaces,
                     std::span<const std::vector<VertexPaint>> paints,
                     const PosedHead& resting,
                     const glm::vec3& towards_camera,
                     Quality quality) {
  DrawnMesh drawn;
  drawn.parts = sort_by_part(surfaces, paints, resting, towards_camera, quality);
  Numbering numbering{all_vertices(surfaces)};
  for (PartTriangles& part : drawn.parts) numbering.renumber(part.near);
  for (PartTriangles& part : drawn.parts) numbering.renumber(part.far);
  drawn.vertices = std::move(numbering).met();
  return drawn;
}

}  // namespace bimodal::synth

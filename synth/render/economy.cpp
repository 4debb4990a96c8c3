#include "synth/render/economy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace bimodal::synth {

namespace {

constexpr std::size_t kIndicesInPatch = 24;

/// Four corners and between them four middles, in the order of the outline.
struct Patch {
  std::uint32_t centre = 0;
  std::array<std::uint32_t, 4> corners{};
  std::array<std::uint32_t, 4> middles{};  // middles[i] lies between corners i and i + 1
};

/// The triangles (q, m, centre) and (q, centre, m') of each corner q, as subdivision leaves them.
std::optional<Patch> patch_of(std::span<const std::uint32_t, kIndicesInPatch> indices) {
  Patch patch;
  patch.centre = indices[2];
  for (std::size_t i = 0; i < 4; ++i) {
    const auto pair = indices.subspan(6 * i, 6);
    const bool is_corner = pair[2] == patch.centre && pair[4] == patch.centre && pair[0] == pair[3];
    if (!is_corner) return std::nullopt;
    patch.corners.at(i) = pair[0];
    patch.middles.at(i) = pair[1];
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (indices[6 * ((i + 1) % 4) + 5] != patch.middles.at(i)) return std::nullopt;
  }
  return patch;
}

/// Largest angle between the normals in a patch that may be drawn coarse.
float largest_angle_deg(Material material) {
  switch (material) {
    case Material::Skin:
      return 20.0F;
    case Material::Tooth:
    case Material::Tongue:
      return 30.0F;
    case Material::Gum:
    case Material::Cornea:
      return 30.0F;
    case Material::Eye:
      return 20.0F;
    case Material::Lash:
      break;
  }
  return 0.0F;
}

bool needs_its_vertices(const SurfaceDescription& surface,
                        const std::vector<VertexPaint>& paint,
                        std::uint32_t vertex) {
  if (surface.material != Material::Skin) return false;
  constexpr float kFaintestLip = 0.03F;
  constexpr float kMouthWall = 2.95F;  // the mask is level from here on inward
  constexpr float kFaintestDarkness = 0.02F;
  const float lip = surface.lip[vertex];
  return (lip > kFaintestLip && lip < kMouthWall) || surface.special[vertex] > kFaintestDarkness ||
         on_brow(paint[vertex].brow);
}

class Coarsening {
 public:
  Coarsening(const SurfaceDescription& surface,
             const std::vector<VertexPaint>& paint,
             std::span<const glm::vec3> normals)
      : surface_{surface},
        paint_{paint},
        normals_{normals},
        smallest_cosine_{std::cos(glm::radians(largest_angle_deg(surface.material)))} {}

  std::vector<std::uint32_t> run() {
    const std::span<const std::uint32_t> all{surface_.triangles};
    std::size_t i = 0;
    while (i < all.size()) {
      std::optional<Patch> patch;
      if (i + kIndicesInPatch <= all.size()) {
        patch = patch_of(all.subspan(i).first<kIndicesInPatch>());
      }
      if (patch && is_plain(*patch)) {
        coarse_.push_back(*patch);
      } else {
        const std::size_t step = patch ? kIndicesInPatch : 3;
        drawn_.insert(drawn_.end(), &all[i], &all[i] + step);
      }
      i += patch ? kIndicesInPatch : 3;
    }
    for (const Patch& patch : coarse_) {
      for (const std::uint32_t middle : patch.middles) ++coarse_sides_[middle];
    }
    for (const Patch& patch : coarse_) add(patch);
    return drawn_;
  }

 private:
  [[nodiscard]] bool is_plain(const Patch& patch) const {
    const auto agrees = [&](std::uint32_t vertex) {
      return glm::dot(normals_[vertex], normals_[patch.centre]) >= smallest_cosine_ &&
             !needs_its_vertices(surface_, paint_, vertex);
    };
    return agrees(patch.centre) && std::ranges::all_of(patch.corners, agrees) &&
           std::ranges::all_of(patch.middles, agrees);
  }

  /// A middle that the neighbour still has must be a vertex here too.
  void add(const Patch& patch) {
    std::vector<std::uint32_t> outline;
    for (std::size_t i = 0; i < 4; ++i) {
      outline.push_back(patch.corners.at(i));
      const bool neighbour_is_coarse = coarse_sides_.at(patch.middles.at(i)) == 2;
      if (!neighbour_is_coarse) outline.push_back(patch.middles.at(i));
    }
    if (outline.size() == 4) {
      add(outline[0], outline[1], outline[2]);
      add(outline[0], outline[2], outline[3]);
      return;
    }
    for (std::size_t i = 0; i < outline.size(); ++i) {
      add(outline[i], outline[(i + 1) % outline.size()], patch.centre);
    }
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    drawn_.insert(drawn_.end(), {a, b, c});
  }

  const SurfaceDescription& surface_;
  const std::vector<VertexPaint>& paint_;
  std::span<const glm::vec3> normals_;
  float smallest_cosine_;
  std::vector<Patch> coarse_;
  std::unordered_map<std::uint32_t, int> coarse_sides_;  // of each middle
  std::vector<std::uint32_t> drawn_;
};

}  // namespace

std::vector<std::uint32_t> triangles_worth_drawing(const SurfaceDescription& surface,
                                                   const std::vector<VertexPaint>& paint,
                                                   std::span<const glm::vec3> normals) {
  return Coarsening{surface, paint, normals}.run();
}

}  // namespace bimodal::synth

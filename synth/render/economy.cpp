#include "synth/render/economy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "synth/render/mesh_patches.hpp"

namespace bimodal::synth {

namespace {

/// Largest angles between the middle's normal and the others' in what may be drawn coarse.
struct Allowance {
  float outline_deg = 0.0F;  ///< in patches that the outline may pass
  float facing_deg = 0.0F;   ///< in patches that face the camera
  float block_deg = 0.0F;    ///< in blocks, which all face the camera
};

Allowance fast_allowance(const SurfaceDescription& surface) {
  switch (surface.material) {
    case Material::Skin:
      return is_ear(surface) ? Allowance{30.0F, 40.0F, 20.0F} : Allowance{21.0F, 30.0F, 18.0F};
    case Material::Tooth:
      return {40.0F, 45.0F, 25.0F};
    case Material::Gum:
    case Material::Tongue:
      return {40.0F, 45.0F, 25.0F};
    case Material::Eye:
      return {40.0F, 40.0F, 30.0F};
    case Material::Cornea:
      return {30.0F, 30.0F, 10.0F};
    case Material::Lash:
      break;
  }
  return {};
}

/// In full quality half of the angles, and no blocks.
Allowance allowance(const SurfaceDescription& surface, Quality quality) {
  const Allowance fast = fast_allowance(surface);
  if (quality == Quality::Fast) return fast;
  return {.outline_deg = 0.5F * fast.outline_deg, .facing_deg = 0.5F * fast.facing_deg};
}

float cosine(float angle_deg) {
  return std::cos(glm::radians(angle_deg));
}

/// What a vertex of the skin has that its neighbours may not have.
enum class Detail : std::uint8_t { None, Brow, Edge };

Detail detail_of(const SurfaceDescription& surface,
                 const std::vector<VertexPaint>& paint,
                 std::uint32_t vertex) {
  if (surface.material != Material::Skin) return Detail::None;
  constexpr float kFaintestLip = 0.2F;
  constexpr float kMouthWall = 2.95F;  // the mask is level from here on inward
  constexpr float kFaintestDarkness = 0.05F;
  const float lip = surface.lip[vertex];
  const bool is_edge =
      (lip > kFaintestLip && lip < kMouthWall) || surface.special[vertex] > kFaintestDarkness;
  if (is_edge) return Detail::Edge;
  return on_brow(paint[vertex].brow) ? Detail::Brow : Detail::None;
}

class Coarsening {
 public:
  Coarsening(const SurfaceDescription& surface,
             const std::vector<VertexPaint>& paint,
             std::span<const glm::vec3> normals,
             const glm::vec3& towards_camera,
             Quality quality)
      : surface_{surface},
        paint_{paint},
        normals_{normals},
        towards_camera_{towards_camera},
        allowance_{allowance(surface, quality)},
        is_needed_(normals.size()),
        sides_(normals.size()) {}

  std::vector<std::uint32_t> run() {
    sort_patches();
    join_patches();
    for (const Patch& patch : patches_) keep(patch.corners);
    for (const Block& block : blocks_) {
      for (const Patch& patch : block) is_needed_[patch.corners[0]] = true;
    }
    for (const Patch& patch : patches_) add(patch);
    for (const Block& block : blocks_) add(block);
    return drawn_;
  }

 private:
  /// Into those worth drawing whole and those that can be coarse.
  void sort_patches() {
    const std::span<const std::uint32_t> all{surface_.triangles};
    std::size_t i = 0;
    while (i < all.size()) {
      std::optional<Patch> patch;
      if (i + kIndicesInPatch <= all.size()) {
        patch = patch_of(all.subspan(i).first<kIndicesInPatch>());
      }
      const std::size_t step = patch ? kIndicesInPatch : 3;
      if (patch && is_plain(*patch)) {
        patches_.push_back(*patch);
        for (const std::uint32_t middle : patch->middles) ++sides_[middle];
      } else {
        keep(all.subspan(i, step));
        drawn_.insert(drawn_.end(), &all[i], &all[i] + step);
      }
      i += step;
    }
  }

  /// Four patches that are as plain together as each alone become a block.
  void join_patches() {
    std::vector<Patch> alone;
    std::size_t i = 0;
    while (i < patches_.size()) {
      std::optional<Block> block;
      if (i + kPatchesInBlock <= patches_.size()) {
        block = block_of(std::span<const Patch>{patches_}.subspan(i).first<kPatchesInBlock>());
      }
      if (block && is_plain(*block)) {
        blocks_.push_back(*block);
        for (const Patch& patch : *block) ++sides_[patch.corners[1]];
        i += kPatchesInBlock;
      } else {
        alone.push_back(patches_[i]);
        ++i;
      }
    }
    patches_ = std::move(alone);
  }

  /// Whether all vertices have normals near the middle's and at most that much detail.
  [[nodiscard]] bool is_plain(const Patch& patch,
                              std::uint32_t middle,
                              float angle_deg,
                              Detail most) const {
    const float smallest_cosine = cosine(angle_deg);
    return all_of(patch, [&](std::uint32_t vertex) {
      return glm::dot(normals_[vertex], normals_[middle]) >= smallest_cosine &&
             detail_of(surface_, paint_, vertex) <= most;
    });
  }

  [[nodiscard]] bool is_plain(const Patch& patch) const {
    const float angle_deg = faces_camera(patch) ? allowance_.facing_deg : allowance_.outline_deg;
    return is_plain(patch, patch.centre, angle_deg, Detail::Brow);
  }

  [[nodiscard]] bool is_plain(const Block& block) const {
    const std::uint32_t middle = block[0].corners[2];
    return std::ranges::all_of(block, [&](const Patch& patch) {
      return faces_camera(patch) && is_plain(patch, middle, allowance_.block_deg, Detail::None) &&
             is_as_hairy(patch, middle);
    });
  }

  [[nodiscard]] bool is_as_hairy(const Patch& patch, std::uint32_t middle) const {
    constexpr float kAlike = 0.1F;
    return all_of(patch, [&](std::uint32_t vertex) {
      return std::abs(surface_.scalp[vertex] - surface_.scalp[middle]) < kAlike;
    });
  }

  /// By so much that a turn of the head, too, does not bring the outline there.
  [[nodiscard]] bool faces_camera(const Patch& patch) const {
    if (surface_.material == Material::Eye) return true;  // its outline is behind the lids
    constexpr float kCosine = 0.4F;
    return all_of(patch, [&](std::uint32_t vertex) {
      return glm::dot(normals_[vertex], towards_camera_) >= kCosine;
    });
  }

  void keep(std::span<const std::uint32_t> vertices) {
    for (const std::uint32_t vertex : vertices) is_needed_[vertex] = true;
  }

  /// Whether the vertex, between two corners, must be one here too: a neighbour has it, or the
  /// surface ends.
  [[nodiscard]] bool is_kept(std::uint32_t vertex) const {
    return is_needed_[vertex] || sides_[vertex] == 1;
  }

  void add(const Patch& patch) {
    outline_.clear();
    for (std::size_t i = 0; i < 4; ++i) {
      outline_.push_back(patch.corners.at(i));
      if (is_kept(patch.middles.at(i))) outline_.push_back(patch.middles.at(i));
    }
    fill_outline(patch.centre);
  }

  void add(const Block& block) {
    outline_.clear();
    for (std::size_t i = 0; i < 4; ++i) {
      const Patch& patch = block.at(i);
      outline_.push_back(patch.corners[0]);
      for (const std::uint32_t vertex :
           {patch.middles[0], patch.corners[1], block.at((i + 1) % 4).middles[3]}) {
        if (is_kept(vertex)) outline_.push_back(vertex);
      }
    }
    fill_outline(block[0].corners[2]);
  }

  void fill_outline(std::uint32_t centre) {
    if (outline_.size() == 4) {
      add(outline_[0], outline_[1], outline_[2]);
      add(outline_[0], outline_[2], outline_[3]);
      return;
    }
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      add(outline_[i], outline_[(i + 1) % outline_.size()], centre);
    }
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    drawn_.insert(drawn_.end(), {a, b, c});
  }

  const SurfaceDescription& surface_;
  const std::vector<VertexPaint>& paint_;
  std::span<const glm::vec3> normals_;
  glm::vec3 towards_camera_;
  Allowance allowance_;
  std::vector<Patch> patches_;   // to be drawn coarse
  std::vector<Block> blocks_;    // to be drawn coarser still
  std::vector<bool> is_needed_;  // by vertex: something drawn has it as a corner
  std::vector<int> sides_;       // by vertex: of how many patches or blocks it is a middle
  std::vector<std::uint32_t> outline_;
  std::vector<std::uint32_t> drawn_;
};

}  // namespace

std::vector<std::uint32_t> triangles_worth_drawing(const SurfaceDescription& surface,
                                                   const std::vector<VertexPaint>& paint,
                                                   std::span<const glm::vec3> normals,
                                                   const glm::vec3& towards_camera,
                                                   Quality quality) {
  return Coarsening{surface, paint, normals, towards_camera, quality}.run();
}

}  // namespace bimodal::synth

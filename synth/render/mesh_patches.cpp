#include "synth/render/mesh_patches.hpp"

namespace bimodal::synth {

namespace {

/// The patch begun at such a corner that `third` is its third; absent if that is no corner.
std::optional<Patch> turned(Patch patch, std::uint32_t third) {
  auto* const found = std::ranges::find(patch.corners, third);
  if (found == patch.corners.end()) return std::nullopt;
  const auto steps = (std::distance(patch.corners.begin(), found) + 2) % 4;
  std::rotate(patch.corners.begin(), patch.corners.begin() + steps, patch.corners.end());
  std::rotate(patch.middles.begin(), patch.middles.begin() + steps, patch.middles.end());
  return patch;
}

std::optional<Block> block_round(std::span<const Patch, kPatchesInBlock> patches,
                                 std::uint32_t centre) {
  Block block;
  for (std::size_t i = 0; i < block.size(); ++i) {
    const auto patch = turned(patches[i], centre);
    if (!patch) return std::nullopt;
    block.at(i) = *patch;
  }
  for (std::size_t i = 0; i < block.size(); ++i) {
    if (block.at(i).corners[1] != block.at((i + 1) % 4).corners[3]) return std::nullopt;
  }
  return block;
}

}  // namespace

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

std::optional<Block> block_of(std::span<const Patch, kPatchesInBlock> patches) {
  for (const std::uint32_t corner : patches[0].corners) {
    if (const auto block = block_round(patches, corner)) return block;
  }
  return std::nullopt;
}

}  // namespace bimodal::synth

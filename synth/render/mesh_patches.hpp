#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace bimodal::synth {

inline constexpr std::size_t kIndicesInPatch = 24;
inline constexpr std::size_t kPatchesInBlock = 4;

/// What a step of subdivision made of one quad, eight triangles: four corners and between them four
/// middles, in the order of the outline.
struct Patch {
  std::uint32_t centre = 0;
  std::array<std::uint32_t, 4> corners{};
  std::array<std::uint32_t, 4> middles{};  // middles[i] lies between corners i and i + 1
};

/// Four patches round one vertex, as the step of subdivision before leaves them: each begins at the
/// block's corner, and the block's centre is its third corner.
using Block = std::array<Patch, kPatchesInBlock>;

/// Absent unless these are the triangles (q, m, centre) and (q, centre, m') of each corner q in
/// turn, as subdivision leaves them.
[[nodiscard]] std::optional<Patch> patch_of(
    std::span<const std::uint32_t, kIndicesInPatch> indices);

/// Absent unless all four meet in one corner, in turn.
[[nodiscard]] std::optional<Block> block_of(std::span<const Patch, kPatchesInBlock> patches);

/// Whether `holds` for each of its nine vertices.
template <typename Condition>
[[nodiscard]] bool all_of(const Patch& patch, Condition holds) {
  return holds(patch.centre) && std::ranges::all_of(patch.corners, holds) &&
         std::ranges::all_of(patch.middles, holds);
}

}  // namespace bimodal::synth

#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace bimodal::synth {

/// What is drawn by one program, in the order of drawing: what hides the rest comes first, the
/// clear ones last.
enum class HeadPart : std::uint8_t {
  Skin,
  Ear,
  Lips,
  Brow,
  Hair,
  Eye,
  MouthWall,
  UpperTooth,
  LowerTooth,
  Gum,
  Palate,
  Tongue,
  Lash,
  Cornea,
};
inline constexpr std::size_t kHeadPartCount = 14;

/// Some of the head's parts, by their place in the enumeration.
using PartSet = std::bitset<kHeadPartCount>;

[[nodiscard]] inline bool has(const PartSet& parts, HeadPart part) {
  return parts[static_cast<std::size_t>(part)];
}

/// Every part.
[[nodiscard]] inline PartSet all_parts() {
  return PartSet{}.set();
}

/// The parts that people name: "lips", "upper_teeth", "teeth" (both rows), "eyes" (with lashes and
/// cornea)...
[[nodiscard]] std::vector<std::string_view> part_names();

/// What a name stands for; absent if it is none of part_names().
[[nodiscard]] std::optional<PartSet> parts_named(std::string_view name);

}  // namespace bimodal::synth

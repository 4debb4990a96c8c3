#pragma once

#include <span>
#include <string_view>

#include "synth/render/materials.hpp"

namespace bimodal::synth {

// What a file of materials may hold, and what each is called in shaders.

struct ColourRow {
  std::string_view section;
  std::string_view key;
  Colour Materials::*member;
  std::string_view constant;
};

/// A light: red, green, blue, 0..10; or a direction towards it.
struct LightRow {
  std::string_view key;
  glm::vec3 Materials::*member;
  bool is_direction;
  std::string_view constant;
};

struct AmountRow {
  std::string_view section;
  std::string_view key;
  float Materials::*member;
  double lowest;
  double highest;
  std::string_view meaning;  ///< completes "give ..."
  std::string_view constant;
};

[[nodiscard]] std::span<const ColourRow> colour_rows();
[[nodiscard]] std::span<const LightRow> light_rows();
[[nodiscard]] std::span<const AmountRow> amount_rows();

}  // namespace bimodal::synth

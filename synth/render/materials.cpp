#include "synth/render/materials.hpp"

#include <fmt/format.h>

#include "synth/render/material_rows.hpp"

namespace bimodal::synth {

namespace {

/// Always with a decimal point, as GLSL wants it.
std::string vector(const glm::vec3& value) {
  return fmt::format("vec3({:#}, {:#}, {:#})", value.x, value.y, value.z);
}

}  // namespace

std::string shader_constants(const Materials& materials) {
  std::string text;
  for (const ColourRow& row : colour_rows()) {
    const Colour& colour = materials.*row.member;
    text += fmt::format(
        "const vec3 {} = {};\n", row.constant, vector({colour[0], colour[1], colour[2]}));
  }
  for (const LightRow& row : light_rows()) {
    text += fmt::format("const vec3 {} = {};\n", row.constant, vector(materials.*row.member));
  }
  for (const AmountRow& row : amount_rows()) {
    text += fmt::format("const float {} = {:#};\n", row.constant, materials.*row.member);
  }
  return text;
}

}  // namespace bimodal::synth

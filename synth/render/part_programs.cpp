#include "synth/render/part_programs.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "synth/render/head_parts.hpp"

namespace bimodal::synth {

namespace {

using enum HeadPart;

bool is_painted_on_skin(HeadPart part) {
  return part == Brow || part == Hair;
}

/// Whether light through the lips alone reaches some of the part.
bool is_in_mouth(HeadPart part) {
  switch (part) {
    case Lips:
    case MouthWall:
    case UpperTooth:
    case LowerTooth:
    case Gum:
    case Palate:
    case Tongue:
      return true;
    default:
      return false;
  }
}

/// What is lost of the dark of the mouth when one sees into it from elsewhere than between the
/// lips.
float mouth_light(const Appearance& appearance) {
  constexpr double kSeenFreely = 0.8;  // the rest keeps its depth
  const bool is_open =
      appearance.cut || !has(appearance.shown, Skin) || !has(appearance.shown, Lips);
  const double seen =
      is_open ? kSeenFreely : kSeenFreely * std::min(1.0, 2.0 * appearance.skin_transparency);
  return std::max(appearance.materials.mouth_light, static_cast<float>(seen));
}

std::string preamble(const Appearance& appearance, HeadPart part) {
  Materials materials = appearance.materials;
  materials.mouth_light = mouth_light(appearance);
  std::string text = shader_constants(materials);
  const Shading shading = appearance.shading.value_or(materials.shading);
  if (shading == Shading::Gouraud) text += "#define GOURAUD 1\n";
  if (shading == Shading::Flat) text += "#define FLAT 1\n";
  if (appearance.cut) text += "#define CUT 1\n";
  if (appearance.quality == Quality::Full) text += "#define FULL 1\n";
  if (is_in_mouth(part)) text += "#define MOUTH 1\n";
  const bool is_alone = !has(appearance.shown, Skin);
  if (is_alone && (is_painted_on_skin(part) || part == Lips)) text += "#define ALONE 1\n";
  return text;
}

PartSet drawn_parts(const PartSet& shown) {
  PartSet drawn = shown;
  if (!has(shown, Skin)) return drawn;
  drawn.set(static_cast<std::size_t>(Brow));
  drawn.set(static_cast<std::size_t>(Hair));
  return drawn;
}

/// Lashes are too fine and the cornea is clear.
PartSet casters_of(const Appearance& appearance) {
  PartSet casters = drawn_parts(appearance.shown);
  for (const HeadPart part : {Lash, Cornea}) casters.reset(static_cast<std::size_t>(part));
  if (!appearance.cut && appearance.skin_transparency == 0.0) return casters;
  for (const HeadPart part : {Skin, Ear, Lips, Brow, Hair, MouthWall}) {
    casters.reset(static_cast<std::size_t>(part));
  }
  return casters;
}

std::vector<Program> compile_parts(const Appearance& appearance) {
  std::vector<Program> programs;
  programs.reserve(kHeadPartCount);
  for (const PartLook& look : part_looks()) {
    const bool is_bare = is_painted_on_skin(look.part) && !has(appearance.shown, look.part);
    const std::string before = preamble(appearance, look.part);
    const std::string_view definition = is_bare ? "" : look.definition;
    if (appearance.quality == Quality::Full) {
      programs.emplace_back(
          ShaderSource{{"light.glsl", "head.vert"},
                       {"noise.glsl", "light.glsl", "shadow.glsl", "surface.glsl", look.shader},
                       definition,
                       before});
    } else {
      programs.emplace_back(ShaderSource{{"light.glsl", "head.vert"},
                                         {"noise.glsl", "light.glsl", "surface.glsl", look.shader},
                                         definition,
                                         before});
    }
  }
  return programs;
}

}  // namespace

bool shows_inside(const Appearance& appearance) {
  return appearance.cut || appearance.skin_transparency > 0.0 || !has(appearance.shown, Skin) ||
         !has(appearance.shown, Lips);
}

PartPrograms::PartPrograms(const Appearance& appearance,
                           const Camera& camera,
                           const glm::mat4& map_from_world)
    : drawn_{drawn_parts(appearance.shown)},
      casters_{casters_of(appearance)},
      programs_{compile_parts(appearance)} {
  const Materials& materials = appearance.materials;
  for (const PartLook& look : part_looks()) {
    const Program& program = programs_.at(static_cast<std::size_t>(look.part));
    program.use();
    program.set("clip_from_world", camera.clip_from_world);
    program.set("map_from_world", map_from_world);
    program.set("camera", camera.position);
    program.set("key_direction", materials.key_direction);
    program.set("fill_direction", materials.fill_direction);
    program.set("sky_floor", look.sky_floor);
    program.set("shadow_floor", look.shadow_floor);
    program.set("softness", look.softness);
    program.set("exponent", look.exponent);
    program.set("grain", look.grain);
    if (appearance.cut) {
      const auto normal = glm::vec3{glm::normalize(appearance.cut->normal)};
      program.set("cut", glm::vec4{normal, -static_cast<float>(appearance.cut->distance_mm)});
    }
  }
}

void PartPrograms::follow(const LipMeasures& lips, const glm::mat3& head_axes) const {
  const glm::vec3 opening{
      0.5 * lips.inner_width_mm, 0.5 * lips.inner_height_mm, lips.inner_area_mm2};
  for (const Program& program : programs_) {
    program.use();
    program.set("head_axes", head_axes);
    program.set("mouth_centre", lips.inner_centre);
    program.set("mouth_opening", opening);
  }
}

}  // namespace bimodal::synth

#include "runner/preparation/drawn_face.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "runner/preparation/point_names.hpp"
#include "runner/preparation/view_names.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/digest.hpp"

namespace bimodal::runner {

namespace {

synth::Backdrop plain(std::uint32_t background) {
  const Colour colour{static_cast<std::uint8_t>((background >> 16U) & 0xffU),
                      static_cast<std::uint8_t>((background >> 8U) & 0xffU),
                      static_cast<std::uint8_t>(background & 0xffU)};
  return {.centre = colour, .edge = colour};
}

std::string material_of(const protocols::Face& face) {
  if (!face.material.empty()) return face.material;
  return face.points == "none" ? "natural" : "point-light";
}

synth::PartSet parts_of(const std::vector<std::string>& names) {
  synth::PartSet parts;
  for (const auto& name : names) parts |= synth::parts_named(name).value_or(synth::PartSet{});
  return parts;
}

synth::Points points_of(const protocols::Face& face) {
  const auto* const found =
      std::ranges::find(kPointNames, face.points, [](const auto& row) { return row.first; });
  return found == kPointNames.end() ? synth::Points::None : found->second;
}

/// Those that are seen whole; both rows of teeth by one name.
std::vector<std::string_view> names_of(const synth::PartSet& shown) {
  std::vector<std::string_view> names;
  for (const auto name : synth::part_names()) {
    const auto parts = *synth::parts_named(name);
    if ((parts & ~shown).none()) names.push_back(name);
  }
  return names;
}

}  // namespace

synth::PartSet shown_parts(const protocols::Face& face) {
  const auto shown = face.show.empty() ? synth::all_parts() : parts_of(face.show);
  return shown & ~parts_of(face.hide);
}

std::filesystem::path material_file(const std::string& material) {
  constexpr std::string_view kFolder = "synth/assets/materials";
  const auto presets = asset_names(kFolder, ".json");
  if (std::ranges::find(presets, material) == presets.end()) return material;
  return asset(std::string{kFolder} + '/' + material + ".json");
}

synth::Pose Bearing::of(synth::Pose speech) const {
  for (const auto& [control, amount] : controls) synth::value(speech, control) = amount;
  return synth::with_expressions(speech, expressions);
}

Bearing bearing_of(const protocols::Face& face) {
  Bearing bearing;
  for (const auto& [name, amount] : face.controls) {
    if (const auto control = synth::control_from_name(name)) {
      bearing.controls.emplace_back(*control, amount);
    }
  }
  for (const auto& [name, strength] : face.expression) {
    if (const auto* const expression = synth::expression_from_name(name)) {
      bearing.expressions.push_back({expression, strength});
    }
  }
  return bearing;
}

synth::Appearance appearance_of(const protocols::Face& face, synth::Quality quality) {
  // Drawn ahead of their presentation, pictures may have smooth edges in full quality.
  constexpr int kFullSamples = 4;
  synth::Appearance appearance;
  appearance.materials = synth::Materials::named(material_of(face));
  appearance.shown = shown_parts(face);
  appearance.skin_transparency = face.transparency;
  appearance.points = points_of(face);
  appearance.quality = quality;
  if (quality == synth::Quality::Full) appearance.samples = kFullSamples;
  return appearance;
}

synth::View view_of(const protocols::Face& face, std::size_t lines, std::uint32_t background) {
  synth::View view{.width = lines * 8 / 9,
                   .height = lines,
                   .centre_y_mm = -32.0,
                   .field_mm = kWholeHead,
                   .backdrop = plain(background)};
  take_view(face.view, view);
  return view;
}

protocols::Face at_rest(protocols::Face face) {
  face.expression.clear();
  face.controls.clear();
  return face;
}

std::string face_record(const protocols::Face& face) {
  const auto material = material_of(face);
  const nlohmann::json record{{"view", face.view},
                              {"material", std::filesystem::path{material}.filename().string()},
                              {"material_sha256", sha256_of_file(material_file(material))},
                              {"shown", names_of(shown_parts(face))},
                              {"transparency", face.transparency},
                              {"points", face.points},
                              {"expression", face.expression},
                              {"controls", face.controls}};
  return record.dump();
}

}  // namespace bimodal::runner

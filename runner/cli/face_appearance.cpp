#include "runner/cli/face_appearance.hpp"

#include <array>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/geometric.hpp>

#include "runner/cli/option_checks.hpp"
#include "runner/preparation/point_names.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/nearest.hpp"

namespace bimodal::runner {

namespace {

constexpr std::array<std::pair<std::string_view, synth::Shading>, 3> kShadings{
    {{"smooth", synth::Shading::Smooth},
     {"gouraud", synth::Shading::Gouraud},
     {"flat", synth::Shading::Flat}}};

synth::PartSet parts_of(std::string_view option, std::span<const std::string> names) {
  synth::PartSet parts;
  for (const std::string& name : names) {
    const auto found = synth::parts_named(name);
    if (!found) {
      const auto known = synth::part_names();
      const auto near = nearest(name, known);
      throw Error{fmt::format("{}: the face has no part '{}'; {}there are {}",
                              option,
                              name,
                              near ? fmt::format("did you mean '{}'? ", *near) : "",
                              fmt::join(known, ", "))};
    }
    parts |= *found;
  }
  return parts;
}

std::optional<synth::Plane> cut_plane(const AppearanceOptions& options, const synth::View& view) {
  if (options.section_mm && !options.clip.empty()) {
    throw Error{"--section and --clip both cut the head; give one of them"};
  }
  if (options.section_mm) {
    const double near_side = view.yaw_deg < 0.0 ? -1.0 : 1.0;
    return synth::Plane{.normal = {near_side, 0.0, 0.0},
                        .distance_mm = near_side * *options.section_mm};
  }
  if (options.clip.empty()) return std::nullopt;
  const glm::dvec3 normal{options.clip[0], options.clip[1], options.clip[2]};
  if (glm::length(normal) == 0.0) {
    throw Error{
        "--clip: the normal 0,0,0 has no direction; give e.g. 0,1,0,-20: all above y = -20 mm"};
  }
  return synth::Plane{.normal = normal, .distance_mm = options.clip[3]};
}

}  // namespace

void add_appearance_options(CLI::App& verb, AppearanceOptions& options) {
  verb.add_option("--material",
                  options.material,
                  "colours and light: natural (default), clay, high-contrast, paper-1993, "
                  "dark-skin, point-light, or a JSON file");
  verb.add_option("--show", options.show, "only these parts, e.g. lips,teeth,tongue")
      ->delimiter(',');
  verb.add_option("--hide", options.hide, "all but these parts, e.g. tongue")->delimiter(',');
  verb.add_option("--transparency", options.transparency, "of the skin: 0 opaque, 1 invisible")
      ->check(finite_number())
      ->check(CLI::Range(0.0, 1.0));
  verb.add_option("--section",
                  options.section_mm,
                  "cut from front to back at this x in mm (0: in the middle); the nearer half goes")
      ->check(finite_number())
      ->check(CLI::Range(-70.0, 70.0));
  verb.add_option("--clip",
                  options.clip,
                  "X,Y,Z,D: take away what lies farther than D mm along a direction")
      ->delimiter(',')
      ->expected(4)
      ->check(finite_number());
  verb.add_option("--shading", options.shading, "smooth, gouraud or flat (as the material says)")
      ->check(CLI::IsMember({"smooth", "gouraud", "flat"}));
  verb.add_option("--points", options.points, "only points of light: sparse, lips or all")
      ->check(CLI::IsMember({"sparse", "lips", "all"}));
  verb.add_option("--quality",
                  options.quality,
                  "fast (default), or full: shadows that follow every movement, finer edges")
      ->check(CLI::IsMember({"fast", "full"}));
}

synth::Appearance face_appearance(const AppearanceOptions& options, const synth::View& view) {
  synth::Appearance appearance;
  const std::string usual = options.points.empty() ? "natural" : "point-light";
  appearance.materials =
      synth::Materials::named(options.material.empty() ? usual : options.material);
  if (!options.show.empty()) appearance.shown = parts_of("--show", options.show);
  appearance.shown &= ~parts_of("--hide", options.hide);
  if (appearance.shown.none()) {
    throw Error{"nothing of the face is left to draw; --hide less, or --show more"};
  }
  appearance.skin_transparency = options.transparency;
  appearance.cut = cut_plane(options, view);
  for (const auto& [name, shading] : kShadings) {
    if (name == options.shading) appearance.shading = shading;
  }
  for (const auto& [name, points] : kPointNames) {
    if (name == options.points) appearance.points = points;
  }
  if (options.quality == "full") {
    constexpr int kSamples = 4;
    appearance.quality = synth::Quality::Full;
    appearance.samples = kSamples;
  }
  return appearance;
}

}  // namespace bimodal::runner

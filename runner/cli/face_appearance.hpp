#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "synth/render/appearance.hpp"
#include "synth/render/view.hpp"

namespace bimodal::runner {

/// What of the face is drawn and how, as the command line says it.
struct AppearanceOptions {
  std::string material;  ///< empty: natural, or for points of light their own
  std::vector<std::string> show;
  std::vector<std::string> hide;
  double transparency = 0.0;
  std::optional<double> section_mm;
  std::vector<double> clip;  ///< x, y, z of the normal and the distance; or none
  std::string shading;
  std::string points;
  std::string quality = "fast";
};

/// Adds --material, --show, --hide, --transparency, --section, --clip, --shading, --points and
/// --quality.
void add_appearance_options(CLI::App& verb, AppearanceOptions& options);

/// A section takes away the half of the head that `view` sees first. Throws Error if what is asked
/// for is not there or cannot be meant.
[[nodiscard]] synth::Appearance face_appearance(const AppearanceOptions& options,
                                                const synth::View& view);

}  // namespace bimodal::runner

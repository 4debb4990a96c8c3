#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "synth/render/view.hpp"

namespace bimodal::runner {

/// From where the face is drawn, as the command line says it. What is absent is as `view` has it.
struct ViewOptions {
  std::string view = "front";
  int height = 720;
  std::string size;  ///< "640x720"; empty: as `height` says
  std::optional<double> yaw_deg;
  std::optional<double> pitch_deg;
  std::optional<double> field_mm;
  std::vector<double> centre_mm;  ///< three or none
  std::optional<double> camera_distance_mm;
  bool orthographic = false;
};

/// Adds --view, --height, --size, --yaw, --pitch, --field, --centre, --camera-distance and
/// --orthographic.
void add_view_options(CLI::App& verb, ViewOptions& options);

/// Eight ninths as wide as high, with an even number of pixels each way (as video needs), if no
/// size is given. Throws Error if the size is none.
[[nodiscard]] synth::View face_view(const ViewOptions& options);

}  // namespace bimodal::runner

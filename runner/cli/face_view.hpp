#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "synth/render/view.hpp"

namespace bimodal::runner {

/// From where the face is drawn, as the command line says it.
struct ViewOptions {
  std::string view = "front";
  int height = 720;
};

/// Adds --view and --height.
void add_view_options(CLI::App& verb, ViewOptions& options);

/// Eight ninths as wide as high, with an even number of pixels each way (as video needs).
[[nodiscard]] synth::View face_view(const ViewOptions& options);

}  // namespace bimodal::runner

#include "runner/cli/face_view.hpp"

namespace bimodal::runner {

void add_view_options(CLI::App& verb, ViewOptions& options) {
  verb.add_option("--view", options.view, "front (default), threequarter, side or mouth")
      ->check(CLI::IsMember({"front", "threequarter", "side", "mouth"}));
  verb.add_option("--height", options.height, "of a picture in pixels (720)")
      ->check(CLI::Range(32, 4096));
}

synth::View face_view(const ViewOptions& options) {
  const auto height = static_cast<std::size_t>(options.height) / 2 * 2;
  synth::View view{.width = height * 8 / 9 / 2 * 2, .height = height};
  if (options.view == "threequarter") view.yaw_deg = 38.0;
  if (options.view == "side") view.yaw_deg = 90.0;
  if (options.view == "mouth") {
    view.centre_y_mm = -70.0;
    view.field_mm = 120.0;
  }
  return view;
}

}  // namespace bimodal::runner

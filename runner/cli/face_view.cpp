#include "runner/cli/face_view.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "runner/cli/option_checks.hpp"
#include "runner/preparation/view_names.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

constexpr int kSmallest = 32;  // pixels
constexpr int kLargest = 4096;
constexpr double kFarthest = 1e5;  // mm

void read_size(const std::string& size, synth::View& view) {
  int width = 0;
  int height = 0;
  int length = 0;
  const int read = std::sscanf(size.c_str(), "%dx%d%n", &width, &height, &length);
  const auto is_side = [](int pixels) {
    return pixels >= kSmallest && pixels <= kLargest && pixels % 2 == 0;
  };
  const bool is_whole = static_cast<std::size_t>(length) == size.size();
  if (read != 2 || !is_whole || !is_side(width) || !is_side(height)) {
    throw Error{
        fmt::format("--size: '{}' is no size of a picture; give width and height in pixels,"
                    " even numbers from {} to {}, e.g. 640x720",
                    size,
                    kSmallest,
                    kLargest)};
  }
  view.width = static_cast<std::size_t>(width);
  view.height = static_cast<std::size_t>(height);
}

}  // namespace

void add_view_options(CLI::App& verb, ViewOptions& options) {
  verb.add_option("--view", options.view, "front (default), threequarter, side or mouth")
      ->check(CLI::IsMember(view_names()));
  verb.add_option("--height", options.height, "of a picture in pixels (720)")
      ->check(CLI::Range(kSmallest, kLargest));
  verb.add_option("--size", options.size, "of a picture in pixels, e.g. 1280x1024");
  verb.add_option("--yaw", options.yaw_deg, "camera to the subject's left, degrees")
      ->check(finite_number())
      ->check(CLI::Range(-180.0, 180.0));
  verb.add_option("--pitch", options.pitch_deg, "camera from above, degrees")
      ->check(finite_number())
      ->check(CLI::Range(-89.0, 89.0));
  verb.add_option("--field", options.field_mm, "height of what is seen, in mm of the head")
      ->check(finite_number())
      ->check(CLI::Range(5.0, 1000.0));
  verb.add_option("--centre",
                  options.centre_mm,
                  "X,Y,Z in mm of what stands in the middle (left, up, forward of the ears)")
      ->delimiter(',')
      ->expected(3)
      ->check(finite_number())
      ->check(CLI::Range(-300.0, 300.0));
  verb.add_option("--camera-distance", options.camera_distance_mm, "from the middle, in mm (1100)")
      ->check(finite_number())
      ->check(CLI::Range(synth::kNearestCamera, kFarthest));
  verb.add_flag("--orthographic", options.orthographic, "parallel lines of sight");
}

synth::View face_view(const ViewOptions& options) {
  const auto height = static_cast<std::size_t>(options.height) / 2 * 2;
  synth::View view{.width = height * 8 / 9 / 2 * 2, .height = height};
  if (!options.size.empty()) read_size(options.size, view);
  take_view(options.view, view);
  view.yaw_deg = options.yaw_deg.value_or(view.yaw_deg);
  view.pitch_deg = options.pitch_deg.value_or(view.pitch_deg);
  view.field_mm = options.field_mm.value_or(view.field_mm);
  view.distance_mm = options.camera_distance_mm.value_or(view.distance_mm);
  if (options.centre_mm.size() == 3) {
    view.centre_x_mm = options.centre_mm[0];
    view.centre_y_mm = options.centre_mm[1];
    view.centre_z_mm = options.centre_mm[2];
  }
  if (options.orthographic) view.projection = synth::Projection::Orthographic;
  return view;
}

}  // namespace bimodal::runner

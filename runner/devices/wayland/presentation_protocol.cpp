#include "runner/devices/wayland/presentation_protocol.hpp"

#include <array>

namespace bimodal::runner {
namespace {

/// Name, signature and types of every message. libwayland keeps the addresses of these tables, so
/// they stay where they are.
struct Tables {
  Tables() = default;
  Tables(const Tables&) = delete;
  Tables& operator=(const Tables&) = delete;
  Tables(Tables&&) = delete;
  Tables& operator=(Tables&&) = delete;
  ~Tables() = default;

  std::array<const wl_interface*, 7> numbers{};
  std::array<const wl_interface*, 1> output{&wl_output_interface};
  std::array<wl_message, 3> feedback_events{{{"sync_output", "o", output.data()},
                                             {"presented", "uuuuuuu", numbers.data()},
                                             {"discarded", "", numbers.data()}}};
  wl_interface feedback{"wp_presentation_feedback", 1, 0, nullptr, 3, feedback_events.data()};
  std::array<const wl_interface*, 2> feedback_types{&wl_surface_interface, &feedback};
  std::array<wl_message, 2> requests{
      {{"destroy", "", numbers.data()}, {"feedback", "on", feedback_types.data()}}};
  std::array<wl_message, 1> events{{{"clock_id", "u", numbers.data()}}};
  wl_interface presentation{"wp_presentation", 1, 2, requests.data(), 1, events.data()};
};

}  // namespace

PresentationProtocol presentation_protocol() {
  static const Tables tables;
  return {.presentation = tables.presentation, .feedback = tables.feedback};
}

}  // namespace bimodal::runner

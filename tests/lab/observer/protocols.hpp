#pragma once

#include <array>
#include <cstdint>

#include <wayland-client.h>

/// wlr-screencopy-unstable-v1, version 1, as the tables that libwayland wants: name, signature,
/// types. libwayland keeps their addresses.
namespace lab {

inline constexpr std::uint32_t kCaptureRegion = 1;  ///< request of the manager
inline constexpr std::uint32_t kCopy = 0;           ///< requests of a frame
inline constexpr std::uint32_t kDestroyFrame = 1;

struct Screencopy {
  std::array<const wl_interface*, 8> numbers{};
  std::array<const wl_interface*, 1> buffer{&wl_buffer_interface};
  std::array<wl_message, 2> frame_requests{
      {{"copy", "o", buffer.data()}, {"destroy", "", numbers.data()}}};
  std::array<wl_message, 4> frame_events{{{"buffer", "uuuu", numbers.data()},
                                          {"flags", "u", numbers.data()},
                                          {"ready", "uuu", numbers.data()},
                                          {"failed", "", numbers.data()}}};
  wl_interface frame{
      "zwlr_screencopy_frame_v1", 1, 2, frame_requests.data(), 4, frame_events.data()};
  std::array<const wl_interface*, 3> output_types{&frame, nullptr, &wl_output_interface};
  std::array<const wl_interface*, 7> region_types{
      &frame, nullptr, &wl_output_interface, nullptr, nullptr, nullptr, nullptr};
  std::array<wl_message, 3> requests{{{"capture_output", "nio", output_types.data()},
                                      {"capture_output_region", "nioiiii", region_types.data()},
                                      {"destroy", "", numbers.data()}}};
  wl_interface manager{"zwlr_screencopy_manager_v1", 1, 3, requests.data(), 0, nullptr};
};

/// The events of a frame, in the protocol's order.
struct FrameListener {
  void (*buffer)(void*,
                 wl_proxy*,
                 std::uint32_t format,
                 std::uint32_t width,
                 std::uint32_t height,
                 std::uint32_t stride);
  void (*flags)(void*, wl_proxy*, std::uint32_t flags);
  void (*ready)(void*,
                wl_proxy*,
                std::uint32_t seconds_high,
                std::uint32_t seconds_low,
                std::uint32_t nanoseconds);
  void (*failed)(void*, wl_proxy*);
};

}  // namespace lab

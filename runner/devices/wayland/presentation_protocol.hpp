#pragma once

#include <cstdint>

#include <wayland-client.h>

namespace bimodal::runner {

/// The two interfaces of presentation-time.xml (version 1), which libwayland does not bring along,
/// as it wants them. Their addresses never change.
struct PresentationProtocol {
  const wl_interface& presentation;
  const wl_interface& feedback;
};

[[nodiscard]] PresentationProtocol presentation_protocol();

inline constexpr std::uint32_t kDestroyRequest = 0;        ///< wp_presentation.destroy
inline constexpr std::uint32_t kFeedbackRequest = 1;       ///< wp_presentation.feedback
inline constexpr std::uint32_t kHardwareClock = 0x2;       ///< wp_presentation_feedback.kind
inline constexpr std::uint32_t kHardwareCompletion = 0x4;  ///< wp_presentation_feedback.kind

/// The events of wp_presentation, in the protocol's order.
struct PresentationListener {
  void (*clock_id)(void*, wl_proxy*, std::uint32_t);
};

/// The events of wp_presentation_feedback, in the protocol's order.
struct FeedbackListener {
  void (*sync_output)(void*, wl_proxy*, wl_output*);
  void (*presented)(void*,
                    wl_proxy*,
                    std::uint32_t seconds_high,
                    std::uint32_t seconds_low,
                    std::uint32_t nanoseconds,
                    std::uint32_t period,
                    std::uint32_t sequence_high,
                    std::uint32_t sequence_low,
                    std::uint32_t kind);
  void (*discarded)(void*, wl_proxy*);
};

/// libwayland takes any table of functions as an array of functions without arguments, and only
/// reads it.
template <typename Listener>
void listen(wl_proxy* proxy, Listener& listener, void* context) {
  wl_proxy_add_listener(proxy, reinterpret_cast<void (**)()>(&listener), context);
}

}  // namespace bimodal::runner

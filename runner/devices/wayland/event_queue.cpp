#include "runner/devices/wayland/event_queue.hpp"

#include <poll.h>
#include <wayland-client.h>

#include "runner/devices/monotonic_clock.hpp"

namespace bimodal::runner {

EventQueue::EventQueue(wl_display* display)
    : display_{display}, queue_{wl_display_create_queue(display)} {}

EventQueue::~EventQueue() {
  wl_event_queue_destroy(queue_);
}

wl_registry* EventQueue::registry() {
  auto* own_display = wrapped(display_);
  auto* registry = wl_display_get_registry(own_display);
  wl_proxy_wrapper_destroy(own_display);
  return registry;
}

void* EventQueue::wrap(void* object) const {
  auto* wrapper = static_cast<wl_proxy*>(wl_proxy_create_wrapper(object));
  wl_proxy_set_queue(wrapper, queue_);
  return wrapper;
}

void EventQueue::roundtrip() {
  wl_display_roundtrip_queue(display_, queue_);
}

bool EventQueue::take(Instant until) {
  if (wl_display_prepare_read_queue(display_, queue_) != 0) {
    return wl_display_dispatch_queue_pending(display_, queue_) >= 0;
  }
  wl_display_flush(display_);
  const int longest_ms = until > MonotonicClock{}.now() ? 1 : 0;
  pollfd readable{.fd = wl_display_get_fd(display_), .events = POLLIN, .revents = 0};
  if (poll(&readable, 1, longest_ms) <= 0) {
    wl_display_cancel_read(display_);
    return true;
  }
  return wl_display_read_events(display_) == 0 &&
         wl_display_dispatch_queue_pending(display_, queue_) >= 0;
}

bool EventQueue::is_connected() const {
  return wl_display_get_error(display_) == 0;
}

void EventQueue::take_read() {
  wl_display_dispatch_queue_pending(display_, queue_);
}

}  // namespace bimodal::runner

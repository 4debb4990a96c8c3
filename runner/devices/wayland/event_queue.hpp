#pragma once

#include "stimuli/base/quantity.hpp"

struct wl_display;
struct wl_event_queue;
struct wl_registry;

namespace bimodal::runner {

/// A queue of our own for events of a connection that belongs to somebody else (SDL): its handlers
/// run only when we say so, and never SDL's. For one thread.
class EventQueue {
 public:
  /// `display` is borrowed and must outlive this.
  explicit EventQueue(wl_display* display);
  EventQueue(const EventQueue&) = delete;
  EventQueue& operator=(const EventQueue&) = delete;
  EventQueue(EventQueue&&) = delete;
  EventQueue& operator=(EventQueue&&) = delete;
  ~EventQueue();

  /// A registry whose events, and those of all that is bound with it, come to this queue. The
  /// caller destroys it.
  [[nodiscard]] wl_registry* registry();

  /// A wrapper of `object`, so that what is made with it sends its events to this queue. The caller
  /// destroys it with wl_proxy_wrapper_destroy.
  template <typename Object>
  [[nodiscard]] Object* wrapped(Object* object) const {
    return static_cast<Object*>(wrap(object));
  }

  /// Waits until the compositor has done all that was asked, and handles its events.
  void roundtrip();

  /// Handles the next batch of events, waiting for it until `until` at most, but not beyond a
  /// millisecond. False: the connection is lost.
  [[nodiscard]] bool take(Instant until);

  /// Whether the compositor is still there.
  [[nodiscard]] bool is_connected() const;

  /// Handles what has been read from the connection, and reads nothing.
  void take_read();

 private:
  [[nodiscard]] void* wrap(void* object) const;

  wl_display* display_;  ///< borrowed
  wl_event_queue* queue_;
};

}  // namespace bimodal::runner

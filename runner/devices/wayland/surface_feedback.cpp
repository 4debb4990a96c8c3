#include "runner/devices/wayland/surface_feedback.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>
#include <string_view>
#include <utility>

#include <poll.h>
#include <wayland-client.h>

#include "runner/devices/monotonic_clock.hpp"

namespace bimodal::runner {
namespace {

// The two interfaces of presentation-time.xml (version 1) as tables: name, signature, types.
constexpr std::uint32_t kDestroyRequest = 0;
constexpr std::uint32_t kFeedbackRequest = 1;
constexpr std::uint32_t kHardwareClock = 0x2;       // wp_presentation_feedback.kind hw_clock
constexpr std::uint32_t kHardwareCompletion = 0x4;  // and hw_completion

/// libwayland keeps the addresses of these tables, so they stay where they are.
struct Protocol {
  Protocol() = default;
  Protocol(const Protocol&) = delete;
  Protocol& operator=(const Protocol&) = delete;
  Protocol(Protocol&&) = delete;
  Protocol& operator=(Protocol&&) = delete;
  ~Protocol() = default;

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

const Protocol& protocol() {
  static const Protocol tables;
  return tables;
}

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
void listen(wl_proxy* proxy, Listener& listener, void* data) {
  wl_proxy_add_listener(proxy, reinterpret_cast<void (**)()>(&listener), data);
}

}  // namespace

struct SurfaceFeedback::Connection {
  wl_display* display = nullptr;
  wl_event_queue* queue = nullptr;
  wl_surface* surface = nullptr;  ///< wrapped, so that its callbacks come to our queue
  wl_registry* registry = nullptr;
  wl_proxy* presentation = nullptr;
  wl_proxy* pending = nullptr;
  std::optional<std::uint32_t> clock;
  bool answered = false;
  std::optional<Instant> shown;
  Duration stated_period{};
  std::uint32_t kind = 0;

  Connection(wl_display* of, wl_surface* about)
      : display{of}, queue{wl_display_create_queue(of)}, surface{wrapped(about)} {
    auto* own_display = wrapped(of);
    registry = wl_display_get_registry(own_display);
    wl_proxy_wrapper_destroy(own_display);
    wl_registry_add_listener(registry, &kRegistryListener, this);
    wl_display_roundtrip_queue(display, queue);  // the globals
    wl_display_roundtrip_queue(display, queue);  // the clock
  }

  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  Connection(Connection&&) = delete;
  Connection& operator=(Connection&&) = delete;

  ~Connection() {
    forget();
    if (presentation != nullptr) {
      wl_proxy_marshal_flags(presentation, kDestroyRequest, nullptr, 1, WL_MARSHAL_FLAG_DESTROY);
    }
    if (registry != nullptr) wl_registry_destroy(registry);
    wl_proxy_wrapper_destroy(surface);
    wl_event_queue_destroy(queue);
  }

  template <typename Object>
  Object* wrapped(Object* object) const {
    auto* wrapper = static_cast<wl_proxy*>(wl_proxy_create_wrapper(object));
    wl_proxy_set_queue(wrapper, queue);
    return reinterpret_cast<Object*>(wrapper);
  }

  void forget() {
    if (pending != nullptr) wl_proxy_destroy(pending);
    pending = nullptr;
  }

  /// Takes one batch of events, waiting for it until `until` at most; false: the connection is
  /// lost.
  bool take_events(Instant until) const {
    if (wl_display_prepare_read_queue(display, queue) != 0) {
      return wl_display_dispatch_queue_pending(display, queue) >= 0;
    }
    wl_display_flush(display);
    const auto left = std::max(until - MonotonicClock{}.now(), Duration::zero());
    const auto whole_ms = std::chrono::ceil<std::chrono::milliseconds>(left).count();
    pollfd readable{.fd = wl_display_get_fd(display), .events = POLLIN, .revents = 0};
    if (poll(&readable, 1, static_cast<int>(whole_ms)) <= 0) {
      wl_display_cancel_read(display);
      return true;
    }
    return wl_display_read_events(display) == 0 &&
           wl_display_dispatch_queue_pending(display, queue) >= 0;
  }

  static Connection& from(void* data) { return *static_cast<Connection*>(data); }

  static void on_global(void* data,
                        wl_registry* registry,
                        std::uint32_t name,
                        const char* interface,
                        std::uint32_t /*version*/) {
    static PresentationListener listener{.clock_id = on_clock_id};
    auto& self = from(data);
    if (std::string_view{interface} != protocol().presentation.name) return;
    if (self.presentation != nullptr) return;
    self.presentation =
        static_cast<wl_proxy*>(wl_registry_bind(registry, name, &protocol().presentation, 1));
    listen(self.presentation, listener, data);
  }

  static void on_global_removed(void* /*data*/, wl_registry* /*registry*/, std::uint32_t /*name*/) {
  }

  static constexpr wl_registry_listener kRegistryListener{.global = on_global,
                                                          .global_remove = on_global_removed};

  static void on_clock_id(void* data, wl_proxy* /*proxy*/, std::uint32_t id) {
    from(data).clock = id;
  }

  static void on_sync_output(void* /*data*/, wl_proxy* /*proxy*/, wl_output* /*output*/) {}

  static void on_presented(void* data,
                           wl_proxy* /*proxy*/,
                           std::uint32_t seconds_high,
                           std::uint32_t seconds_low,
                           std::uint32_t nanoseconds,
                           std::uint32_t period,
                           std::uint32_t /*sequence_high*/,
                           std::uint32_t /*sequence_low*/,
                           std::uint32_t kind) {
    auto& self = from(data);
    const auto seconds = (std::uint64_t{seconds_high} << 32U) | seconds_low;
    self.answered = true;
    self.shown = Instant{std::chrono::seconds{seconds} + std::chrono::nanoseconds{nanoseconds}};
    self.stated_period = Duration{period};
    self.kind = kind;
    self.forget();
  }

  static void on_frame_drawn(void* data, wl_callback* /*callback*/, std::uint32_t /*time*/) {
    auto& self = from(data);
    self.answered = true;
    self.shown = MonotonicClock{}.now();
    self.forget();
  }

  static void on_discarded(void* data, wl_proxy* /*proxy*/) {
    auto& self = from(data);
    self.answered = true;
    self.forget();
  }
};

SurfaceFeedback::SurfaceFeedback(wl_display* display, wl_surface* surface)
    : connection_{std::make_unique<Connection>(display, surface)} {}

SurfaceFeedback::~SurfaceFeedback() = default;

bool SurfaceFeedback::offers(Kind kind) const {
  return kind == Kind::FrameDrawn || connection_->clock == std::uint32_t{CLOCK_MONOTONIC};
}

void SurfaceFeedback::request(Kind kind) {
  static FeedbackListener listener{.sync_output = Connection::on_sync_output,
                                   .presented = Connection::on_presented,
                                   .discarded = Connection::on_discarded};
  static constexpr wl_callback_listener kFrameListener{.done = Connection::on_frame_drawn};
  auto& self = *connection_;
  self.forget();
  self.answered = false;
  self.shown.reset();
  if (kind == Kind::FrameDrawn) {
    auto* callback = wl_surface_frame(self.surface);
    wl_callback_add_listener(callback, &kFrameListener, connection_.get());
    self.pending = reinterpret_cast<wl_proxy*>(callback);
  } else {
    self.pending = wl_proxy_marshal_flags(
        self.presentation, kFeedbackRequest, &protocol().feedback, 1, 0, self.surface, nullptr);
    listen(self.pending, listener, connection_.get());
  }
}

std::optional<Instant> SurfaceFeedback::await(Duration patience) {
  auto& self = *connection_;
  const auto until = MonotonicClock{}.now() + patience;
  while (!self.answered && self.take_events(until)) {
    if (MonotonicClock{}.now() >= until) break;
  }
  self.forget();
  return self.shown;
}

Duration SurfaceFeedback::stated_period() const {
  return connection_->stated_period;
}

bool SurfaceFeedback::hardware_stamped() const {
  constexpr auto kByHardware = kHardwareClock | kHardwareCompletion;
  return (connection_->kind & kByHardware) == kByHardware;
}

}  // namespace bimodal::runner

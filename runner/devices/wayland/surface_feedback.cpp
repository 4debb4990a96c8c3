#include "runner/devices/wayland/surface_feedback.hpp"

#include <chrono>
#include <cstdint>
#include <ctime>

#include <wayland-client.h>

#include "runner/devices/device_error.hpp"
#include "runner/devices/monotonic_clock.hpp"
#include "runner/devices/wayland/event_queue.hpp"
#include "runner/devices/wayland/presentation_protocol.hpp"

namespace bimodal::runner {
namespace {

/// What `clock` of this machine is ahead of the session clock; absent: it has no such clock.
std::optional<Duration> ahead_of_session(clockid_t clock) {
  if (clock == CLOCK_MONOTONIC) return Duration::zero();
  timespec time{};
  if (clock_gettime(clock, &time) != 0) return std::nullopt;
  const Duration reading =
      std::chrono::seconds{time.tv_sec} + std::chrono::nanoseconds{time.tv_nsec};
  return reading - MonotonicClock{}.now().time_since_epoch();
}

std::uint64_t joined(std::uint32_t high, std::uint32_t low) {
  return (std::uint64_t{high} << 32U) | low;
}

}  // namespace

struct SurfaceFeedback::Connection {
  EventQueue queue;
  wl_surface* surface;  ///< wrapped, so that its callbacks come to our queue
  wl_registry* registry;
  wl_proxy* presentation = nullptr;
  wl_proxy* pending = nullptr;
  std::optional<clockid_t> clock;
  bool answered = false;
  std::optional<PresentationReport> report;
  Duration stated_period{};
  std::uint32_t kind = 0;

  Connection(wl_display* display, wl_surface* about)
      : queue{display}, surface{queue.wrapped(about)}, registry{queue.registry()} {
    wl_registry_add_listener(registry, &kRegistryListener, this);
    queue.roundtrip();  // the globals
    queue.roundtrip();  // the clock
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
    wl_registry_destroy(registry);
    wl_proxy_wrapper_destroy(surface);
  }

  void forget() {
    if (pending != nullptr) wl_proxy_destroy(pending);
    pending = nullptr;
  }

  static Connection& from(void* context) { return *static_cast<Connection*>(context); }

  static void on_global(void* context,
                        wl_registry* registry,
                        std::uint32_t name,
                        const char* interface,
                        std::uint32_t /*version*/) {
    static PresentationListener listener{.clock_id = on_clock_id};
    auto& self = from(context);
    const auto& wanted = presentation_protocol().presentation;
    if (std::string_view{interface} != wanted.name || self.presentation != nullptr) return;
    self.presentation = static_cast<wl_proxy*>(wl_registry_bind(registry, name, &wanted, 1));
    listen(self.presentation, listener, context);
  }

  static void on_global_removed(void* /*context*/, wl_registry* /*registry*/, std::uint32_t) {}

  static constexpr wl_registry_listener kRegistryListener{.global = on_global,
                                                          .global_remove = on_global_removed};

  static void on_clock_id(void* context, wl_proxy* /*proxy*/, std::uint32_t id) {
    from(context).clock = static_cast<clockid_t>(id);
  }

  static void on_sync_output(void* /*context*/, wl_proxy* /*proxy*/, wl_output* /*output*/) {}

  static void on_presented(void* context,
                           wl_proxy* /*proxy*/,
                           std::uint32_t seconds_high,
                           std::uint32_t seconds_low,
                           std::uint32_t nanoseconds,
                           std::uint32_t period,
                           std::uint32_t sequence_high,
                           std::uint32_t sequence_low,
                           std::uint32_t kind) {
    auto& self = from(context);
    self.answered = true;
    self.stated_period = Duration{period};
    self.kind = kind;
    self.forget();
    const auto ahead = ahead_of_session(*self.clock);
    if (!ahead) return;
    const Instant shown{std::chrono::seconds{joined(seconds_high, seconds_low)} +
                        std::chrono::nanoseconds{nanoseconds}};
    self.report = {.shown = shown - *ahead, .refresh = std::nullopt};
    const auto sequence = joined(sequence_high, sequence_low);
    if (sequence != 0) self.report->refresh = sequence;  // 0: the output counts none
  }

  static void on_frame_drawn(void* context, wl_callback* /*callback*/, std::uint32_t /*time*/) {
    auto& self = from(context);
    self.answered = true;
    self.report = {.shown = MonotonicClock{}.now(), .refresh = std::nullopt};
    self.forget();
  }

  static void on_discarded(void* context, wl_proxy* /*proxy*/) {
    auto& self = from(context);
    self.answered = true;
    self.forget();
  }
};

SurfaceFeedback::SurfaceFeedback(wl_display* display, wl_surface* surface, Kind kind)
    : kind_{kind}, connection_{std::make_unique<Connection>(display, surface)} {}

SurfaceFeedback::~SurfaceFeedback() = default;

std::string SurfaceFeedback::refusal() const {
  if (kind_ == Kind::FrameDrawn) return {};
  if (connection_->presentation == nullptr) return "the compositor does not offer it";
  if (!connection_->clock || !ahead_of_session(*connection_->clock)) {
    return "the compositor names no clock of this machine";
  }
  return {};
}

void SurfaceFeedback::request() {
  static FeedbackListener listener{.sync_output = Connection::on_sync_output,
                                   .presented = Connection::on_presented,
                                   .discarded = Connection::on_discarded};
  static constexpr wl_callback_listener kFrameListener{.done = Connection::on_frame_drawn};
  auto& self = *connection_;
  self.forget();
  self.answered = false;
  self.report.reset();
  if (kind_ == Kind::FrameDrawn) {
    auto* callback = wl_surface_frame(self.surface);
    wl_callback_add_listener(callback, &kFrameListener, connection_.get());
    self.pending = reinterpret_cast<wl_proxy*>(callback);
  } else {
    self.pending = wl_proxy_marshal_flags(self.presentation,
                                          kFeedbackRequest,
                                          &presentation_protocol().feedback,
                                          1,
                                          0,
                                          self.surface,
                                          nullptr);
    listen(self.pending, listener, connection_.get());
  }
}

std::optional<PresentationReport> SurfaceFeedback::await(Duration patience,
                                                         const Meanwhile& meanwhile) {
  auto& self = *connection_;
  const auto until = MonotonicClock{}.now() + patience;
  while (!self.answered && self.queue.take(until)) {
    meanwhile();
    if (MonotonicClock{}.now() >= until) break;
  }
  if (!self.queue.is_connected()) {
    throw DisplayLost{
        "the screen was lost: the compositor has gone; what is stored is kept, go on by `bimodal "
        "run ... --resume`"};
  }
  self.forget();
  return self.report;
}

TimeSource SurfaceFeedback::source() const {
  return kind_ == Kind::Presented ? TimeSource::DriverReported : TimeSource::SwapReturned;
}

Duration SurfaceFeedback::stated_period() const {
  return connection_->stated_period;
}

std::string_view SurfaceFeedback::name() const {
  return kind_ == Kind::Presented ? "wp_presentation" : "frame callbacks";
}

std::string SurfaceFeedback::description() const {
  if (kind_ == Kind::FrameDrawn) {
    return "from the compositor's frame callbacks, up to one refresh before a picture is visible";
  }
  return std::string{"reported by the compositor (wp_presentation), stamped by "} +
         (by_hardware() ? "the display hardware" : "its own clock");
}

bool SurfaceFeedback::by_hardware() const {
  constexpr auto kByHardware = kHardwareClock | kHardwareCompletion;
  return kind_ == Kind::Presented && (connection_->kind & kByHardware) == kByHardware;
}

}  // namespace bimodal::runner

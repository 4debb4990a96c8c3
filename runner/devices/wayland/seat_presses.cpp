#include "runner/devices/wayland/seat_presses.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include <unistd.h>
#include <wayland-client.h>

#include "runner/devices/wayland/event_queue.hpp"

namespace bimodal::runner {
namespace {

constexpr std::size_t kMostPresses = 64;

/// The version that lets go of keyboards and pointers, and has no events beyond those below.
constexpr std::uint32_t kSeatVersion = 3;

}  // namespace

struct SeatPresses::Connection {
  EventQueue queue;
  wl_registry* registry;
  wl_seat* seat = nullptr;
  wl_keyboard* keyboard = nullptr;
  wl_pointer* pointer = nullptr;
  std::array<SeatPress, kMostPresses> presses{};
  std::size_t count = 0;

  explicit Connection(wl_display* display) : queue{display}, registry{queue.registry()} {
    wl_registry_add_listener(registry, &kRegistryListener, this);
    queue.roundtrip();  // the globals
    queue.roundtrip();  // what the seat can do
  }

  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  Connection(Connection&&) = delete;
  Connection& operator=(Connection&&) = delete;

  ~Connection() {
    let_keyboard_go();
    let_pointer_go();
    if (seat != nullptr) wl_seat_destroy(seat);
    wl_registry_destroy(registry);
  }

  void let_keyboard_go() {
    if (keyboard != nullptr) wl_keyboard_release(keyboard);
    keyboard = nullptr;
  }

  void let_pointer_go() {
    if (pointer != nullptr) wl_pointer_release(pointer);
    pointer = nullptr;
  }

  void add(std::uint32_t code, std::uint32_t milliseconds) {
    if (count < kMostPresses) presses[count++] = {.code = code, .milliseconds = milliseconds};
  }

  static Connection& from(void* context) { return *static_cast<Connection*>(context); }

  static void on_global(void* context,
                        wl_registry* registry,
                        std::uint32_t name,
                        const char* interface,
                        std::uint32_t version) {
    auto& self = from(context);
    if (std::string_view{interface} != wl_seat_interface.name) return;
    if (self.seat != nullptr || version < kSeatVersion) return;
    self.seat =
        static_cast<wl_seat*>(wl_registry_bind(registry, name, &wl_seat_interface, kSeatVersion));
    wl_seat_add_listener(self.seat, &kSeatListener, context);
  }

  static void on_global_removed(void* /*context*/, wl_registry* /*registry*/, std::uint32_t) {}

  static void on_capabilities(void* context, wl_seat* seat, std::uint32_t capabilities) {
    auto& self = from(context);
    const bool has_keyboard = (capabilities & WL_SEAT_CAPABILITY_KEYBOARD) != 0;
    const bool has_pointer = (capabilities & WL_SEAT_CAPABILITY_POINTER) != 0;
    if (!has_keyboard) self.let_keyboard_go();
    if (!has_pointer) self.let_pointer_go();
    if (has_keyboard && self.keyboard == nullptr) {
      self.keyboard = wl_seat_get_keyboard(seat);
      wl_keyboard_add_listener(self.keyboard, &kKeyboardListener, context);
    }
    if (has_pointer && self.pointer == nullptr) {
      self.pointer = wl_seat_get_pointer(seat);
      wl_pointer_add_listener(self.pointer, &kPointerListener, context);
    }
  }

  static void on_name(void* /*context*/, wl_seat* /*seat*/, const char* /*name*/) {}

  static void on_keymap(void* /*context*/,
                        wl_keyboard* /*keyboard*/,
                        std::uint32_t /*format*/,
                        std::int32_t descriptor,
                        std::uint32_t /*size*/) {
    close(descriptor);
  }

  static void on_keyboard_enter(
      void* /*context*/, wl_keyboard*, std::uint32_t /*serial*/, wl_surface*, wl_array* /*keys*/) {}

  static void on_keyboard_leave(void* /*context*/, wl_keyboard*, std::uint32_t, wl_surface*) {}

  static void on_key(void* context,
                     wl_keyboard* /*keyboard*/,
                     std::uint32_t /*serial*/,
                     std::uint32_t milliseconds,
                     std::uint32_t key,
                     std::uint32_t state) {
    if (state == WL_KEYBOARD_KEY_STATE_PRESSED) from(context).add(key, milliseconds);
  }

  static void on_modifiers(void* /*context*/,
                           wl_keyboard* /*keyboard*/,
                           std::uint32_t /*serial*/,
                           std::uint32_t /*depressed*/,
                           std::uint32_t /*latched*/,
                           std::uint32_t /*locked*/,
                           std::uint32_t /*group*/) {}

  static void on_pointer_enter(
      void* /*context*/, wl_pointer*, std::uint32_t, wl_surface*, wl_fixed_t, wl_fixed_t) {}

  static void on_pointer_leave(void* /*context*/, wl_pointer*, std::uint32_t, wl_surface*) {}

  static void on_motion(void* /*context*/, wl_pointer*, std::uint32_t, wl_fixed_t, wl_fixed_t) {}

  static void on_button(void* context,
                        wl_pointer* /*pointer*/,
                        std::uint32_t /*serial*/,
                        std::uint32_t milliseconds,
                        std::uint32_t button,
                        std::uint32_t state) {
    if (state == WL_POINTER_BUTTON_STATE_PRESSED) from(context).add(button, milliseconds);
  }

  static void on_axis(void* /*context*/, wl_pointer*, std::uint32_t, std::uint32_t, wl_fixed_t) {}

  static constexpr wl_registry_listener kRegistryListener{.global = on_global,
                                                          .global_remove = on_global_removed};
  static constexpr wl_seat_listener kSeatListener{.capabilities = on_capabilities, .name = on_name};
  static constexpr wl_keyboard_listener kKeyboardListener{.keymap = on_keymap,
                                                          .enter = on_keyboard_enter,
                                                          .leave = on_keyboard_leave,
                                                          .key = on_key,
                                                          .modifiers = on_modifiers,
                                                          .repeat_info = nullptr};
  static constexpr wl_pointer_listener kPointerListener{.enter = on_pointer_enter,
                                                        .leave = on_pointer_leave,
                                                        .motion = on_motion,
                                                        .button = on_button,
                                                        .axis = on_axis,
                                                        .frame = nullptr,
                                                        .axis_source = nullptr,
                                                        .axis_stop = nullptr,
                                                        .axis_discrete = nullptr};
};

SeatPresses::SeatPresses(wl_display* display)
    : connection_{std::make_unique<Connection>(display)} {}

SeatPresses::~SeatPresses() = default;

std::span<const SeatPress> SeatPresses::collect() {
  auto& self = *connection_;
  self.count = 0;
  self.queue.take_read();
  return std::span{self.presses}.first(self.count);
}

bool SeatPresses::has_seat() const {
  return connection_->seat != nullptr;
}

}  // namespace bimodal::runner

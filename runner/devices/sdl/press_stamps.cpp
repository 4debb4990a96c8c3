#include "runner/devices/sdl/press_stamps.hpp"

#include <utility>

#include <SDL_syswm.h>
#include <fmt/format.h>

#include "runner/devices/sdl/press_codes.hpp"

namespace bimodal::runner {
namespace {

std::unique_ptr<SeatPresses> seat_of(const SdlWindow& window) {
  SDL_SysWMinfo native;
  SDL_VERSION(&native.version);
  if (SDL_GetWindowWMInfo(window.native(), &native) != SDL_TRUE) return nullptr;
  if (native.subsystem != SDL_SYSWM_WAYLAND) return nullptr;
  auto seat = std::make_unique<SeatPresses>(native.info.wl.display);
  return seat->has_seat() ? std::move(seat) : nullptr;
}

}  // namespace

PressStamps::PressStamps(const SdlWindow& window)
    : seat_{seat_of(window)}, on_x11_{SdlWindow::driver() == "x11"} {}

void PressStamps::collect(const Clock& clock) {
  for (const auto& press : evdev_.collect()) kernel_.add(press.code, press.at);
  if (!seat_) return;
  const auto now = clock.now();
  for (const auto& press : seat_->collect()) {
    compositor_.add(press.code, unwrapped(press.milliseconds, now));
  }
}

InputStamp PressStamps::of(const NoticedEvent& noticed) {
  const auto nothing_before = noticed.at - noticed.unnoticed;
  if (noticed.event.type == SDL_TEXTINPUT && last_key_ &&
      last_key_->nothing_before == nothing_before) {
    return last_key_->stamp;
  }
  const auto stamp = of_press(noticed);
  if (noticed.event.type == SDL_KEYDOWN) {
    last_key_ = {.nothing_before = nothing_before, .stamp = stamp};
  }
  return stamp;
}

/// Every source is asked, so that none keeps what has been found by another.
InputStamp PressStamps::of_press(const NoticedEvent& noticed) {
  InputStamp stamp{.at = noticed.at, .uncertainty = noticed.unnoticed, .source = "poll"};
  if (noticed.server) {
    const auto told = server_.stamp(noticed.server->milliseconds, noticed.at, noticed.unnoticed);
    if (told) stamp = *told;
  }
  auto code = press_code(noticed.event);
  if (!code) return stamp;
  const auto seat = compositor_.take(*code, noticed.at, noticed.unnoticed);
  if (seat) stamp = stamp_of_count(*seat, SeatPresses::kGrain, noticed.at, "compositor");
  if (noticed.server && noticed.server->is_key) code = noticed.server->code;
  const auto kernel = kernel_.take(*code, noticed.at, noticed.unnoticed);
  if (kernel) stamp = stamp_of_count(*kernel, EvdevPresses::kGrain, noticed.at, "evdev");
  return stamp;
}

std::string PressStamps::description() const {
  const auto* const window_system =
      seat_     ? "stamps of the compositor, to 1 ms, where they are on the session clock"
      : on_x11_ ? "stamps of the X server, to 2 ms, where they follow the session clock"
                : "no stamps of a window system";
  const auto kernel =
      evdev_.refusal().empty()
          ? fmt::format("stamps of the kernel, to 1 us, of {} input devices", evdev_.devices())
          : fmt::format("not the kernel's (evdev): {}", evdev_.refusal());
  return fmt::format(
      "{}; {}; else the instant at which an event was noticed", kernel, window_system);
}

}  // namespace bimodal::runner

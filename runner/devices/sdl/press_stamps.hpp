#pragma once

#include <memory>
#include <optional>
#include <string>

#include "runner/devices/evdev/evdev_presses.hpp"
#include "runner/devices/sdl/noticed_events.hpp"
#include "runner/devices/wayland/seat_presses.hpp"
#include "runner/timing/input_stamp.hpp"
#include "runner/timing/millisecond_clock.hpp"
#include "runner/timing/stamp_matcher.hpp"

namespace bimodal::runner {

/// Gives each noticed event the best stamp that there is for it:
///  - "evdev": the kernel's, to the microsecond, where its devices may be read;
///  - "compositor": Wayland's, to the millisecond;
///  - "server": X11's, to two milliseconds;
///  - "poll": when it was noticed, and how long it may have waited for that.
/// Joystick buttons are always polled. Text has the stamp of the key that brought it.
class PressStamps {
 public:
  /// `window` is borrowed and must outlive this.
  explicit PressStamps(const SdlWindow& window);

  /// Takes in what the sources have; after the pump, before stamping what was noticed in it.
  void collect(const Clock& clock);

  /// Each event once, in order.
  [[nodiscard]] InputStamp of(const NoticedEvent& noticed);

  /// Which sources there are, and why the better ones are not.
  [[nodiscard]] std::string description() const;

 private:
  [[nodiscard]] InputStamp of_press(const NoticedEvent& noticed);

  EvdevPresses evdev_;
  StampMatcher kernel_;
  std::unique_ptr<SeatPresses> seat_;  ///< under Wayland
  StampMatcher compositor_;
  MillisecondClock server_{"server"};
  bool on_x11_ = false;

  struct KeyStamp {
    Instant nothing_before;
    InputStamp stamp;
  };

  std::optional<KeyStamp> last_key_;  ///< and the pump in which it was noticed
};

}  // namespace bimodal::runner

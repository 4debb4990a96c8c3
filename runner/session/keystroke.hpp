#pragma once

#include <string>
#include <string_view>

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

enum class Key {
  Text,
  Backspace,
  Enter,
  Left,
  Escape,
  WindowClosed,
  Pointer,  ///< a button of the mouse, at a place
  Button    ///< of a button box (a joystick to the system)
};

struct Keystroke {
  Key key = Key::Text;
  std::string text;  ///< UTF-8, for Key::Text
  /// Word of the press reached the source of the stamp within [at - uncertainty, at]. What comes
  /// before is not known: the keyboard's own scanning and sending, some 1 to 20 ms, and for "poll"
  /// the way through the window system.
  Instant at;
  Duration uncertainty{};
  /// "evdev" (stamped by the kernel), "compositor" (the same, handed on in whole milliseconds),
  /// "server" (by the X server), "poll" (noticed by this program at `at`, and not yet `uncertainty`
  /// earlier), "simulated".
  std::string_view source;
  int button = 0;  ///< Pointer: 1 left, 2 middle, 3 right; Button: from 1 in the device's order
  double x = 0.0;  ///< Pointer: part of the window's width
  double y = 0.0;  ///< Pointer: part of the window's height, from the top
};

/// Whether it comes from the mouse or a button box, and not from the keyboard.
[[nodiscard]] inline bool is_button_press(const Keystroke& stroke) {
  return stroke.key == Key::Pointer || stroke.key == Key::Button;
}

/// Whether somebody wants the session to end.
[[nodiscard]] inline bool asks_to_stop(const Keystroke& stroke) {
  return stroke.key == Key::Escape || stroke.key == Key::WindowClosed;
}

/// How a keystroke is stored: the text, "Backspace", "Enter" ..., "Pointer1 0.5000 0.2500" (button
/// and place), "Button1".
[[nodiscard]] std::string label(const Keystroke& stroke);

}  // namespace bimodal::runner

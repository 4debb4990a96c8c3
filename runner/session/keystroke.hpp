#pragma once

#include <string>
#include <string_view>

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

enum class Key { Text, Backspace, Enter, Left, Escape, WindowClosed };

struct Keystroke {
  Key key = Key::Text;
  std::string text;  ///< UTF-8, for Key::Text
  Instant at;
  std::string_view source;  ///< "poll": noticed when polled; "simulated"
};

/// Whether somebody wants the session to end.
[[nodiscard]] inline bool asks_to_stop(const Keystroke& stroke) {
  return stroke.key == Key::Escape || stroke.key == Key::WindowClosed;
}

/// "Backspace", "Enter" ..., or the text: how a keystroke is stored.
[[nodiscard]] std::string label(const Keystroke& stroke);

}  // namespace bimodal::runner

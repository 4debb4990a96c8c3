#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runner/session/keystroke.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// Where answers come from: keys, clicks, buttons. Used by the display's thread.
class Keyboard {
 public:
  Keyboard() = default;
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;
  Keyboard(Keyboard&&) = delete;
  Keyboard& operator=(Keyboard&&) = delete;
  virtual ~Keyboard() = default;

  /// The keystrokes since the last call, in the order in which they were noticed.
  [[nodiscard]] virtual std::vector<Keystroke> poll() = 0;

  /// Tells a simulated participant that an answer is awaited from `from` on, and which it gives;
  /// a real keyboard ignores it.
  virtual void expect(std::string_view answer, Instant from) = 0;

  /// Shows or hides the mouse cursor, which is hidden at first; without a screen it does nothing.
  /// Clicks come either way.
  virtual void show_pointer(bool /*shown*/) {}

  /// What it is, and how its instants are found.
  [[nodiscard]] virtual std::string description() const = 0;
};

}  // namespace bimodal::runner

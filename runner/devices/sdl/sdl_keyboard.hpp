#pragma once

#include <optional>

#include "runner/devices/clock.hpp"
#include "runner/devices/keyboard.hpp"
#include "runner/devices/sdl/sdl_window.hpp"

union SDL_Event;

namespace bimodal::runner {

/// What an event of SDL means to the session, if anything, noticed at `now`. Held keys repeat text
/// and Backspace, but neither Enter nor Escape, which would answer the next question unread.
[[nodiscard]] std::optional<Keystroke> keystroke_of(const SDL_Event& event, Instant now);

/// The keyboard of the participant's window. SDL 2 stamps a key when it is polled, not when it was
/// pressed; so each is stamped with the session clock at the poll, up to one poll interval (one
/// refresh) late, and its source is "poll". Closing the window is a keystroke as well. When the
/// window loses the keyboard it is asked for again.
class SdlKeyboard final : public Keyboard {
 public:
  /// Both are borrowed and must outlive the keyboard. What was typed before is forgotten.
  SdlKeyboard(SdlWindow& window, const Clock& clock);

  [[nodiscard]] std::vector<Keystroke> poll() override;

  /// A person needs no telling.
  void expect(std::string_view answer, Instant from) override;

 private:
  SdlWindow& window_;   ///< borrowed
  const Clock& clock_;  ///< borrowed
};

}  // namespace bimodal::runner

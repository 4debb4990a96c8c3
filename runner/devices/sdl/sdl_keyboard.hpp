#pragma once

#include <memory>
#include <optional>
#include <string>

#include "runner/devices/clock.hpp"
#include "runner/devices/keyboard.hpp"
#include "runner/devices/sdl/sdl_window.hpp"
#include "runner/timing/input_stamp.hpp"

union SDL_Event;

namespace bimodal::runner {

/// What an event of SDL means to the session, if anything. `points` is the window's size in the
/// unit of mouse positions. Held keys repeat text and Backspace, but neither Enter nor Escape,
/// which would answer the next question unread.
[[nodiscard]] std::optional<Keystroke> keystroke_of(const SDL_Event& event,
                                                    const InputStamp& stamp,
                                                    SdlWindow::Size points);

/// Keyboard, mouse and button boxes of the participant's window. SDL 2 stamps a key when it takes
/// it in, not when it was pressed. Better stamps are found by other ways (PressStamps) where there
/// are any; else the instant is that at which the window's pump took the event in, and the
/// uncertainty the time since the pump before: a millisecond while the display waits, up to a
/// refresh where a swap blocks. Closing the window is a keystroke as well. When the window loses
/// the keyboard it is asked for again.
class SdlKeyboard final : public Keyboard {
 public:
  /// Both are borrowed and must outlive the keyboard. What was typed before is forgotten.
  SdlKeyboard(SdlWindow& window, const Clock& clock);
  SdlKeyboard(const SdlKeyboard&) = delete;
  SdlKeyboard& operator=(const SdlKeyboard&) = delete;
  SdlKeyboard(SdlKeyboard&&) = delete;
  SdlKeyboard& operator=(SdlKeyboard&&) = delete;
  ~SdlKeyboard() override;

  [[nodiscard]] std::vector<Keystroke> poll() override;

  /// A person needs no telling.
  void expect(std::string_view answer, Instant from) override;

  void show_pointer(bool shown) override;

  [[nodiscard]] std::string description() const override;

 private:
  struct Sources;
  SdlWindow& window_;   ///< borrowed
  const Clock& clock_;  ///< borrowed
  std::unique_ptr<Sources> sources_;
};

}  // namespace bimodal::runner

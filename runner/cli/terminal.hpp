#pragma once

#include <optional>
#include <string>
#include <vector>

#include <termios.h>

#include "runner/monitor/monitor_screen.hpp"

namespace bimodal::runner {

/// The user's terminal as a screen that is repainted in place, with plain ANSI sequences, and keys
/// that come at once. On an alternate screen: what stood there before comes back at the end, also
/// after SIGTERM and SIGHUP, which end a wait. One at a time.
class Terminal {
 public:
  /// Whether both standard input and output are one.
  [[nodiscard]] static bool is_there();

  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  Terminal(Terminal&&) = delete;
  Terminal& operator=(Terminal&&) = delete;

  [[nodiscard]] ScreenSize size() const;

  /// Paints those rows that differ from what is on the screen.
  void paint(const std::vector<std::string>& rows);

  /// The next key, if one was pressed: a letter, or '\3' for Ctrl-C. Keys that send more than one
  /// byte (arrows) give nothing.
  [[nodiscard]] std::optional<char> key() const;

  /// Whether the program was asked to end, or the terminal has gone.
  [[nodiscard]] static bool leave_asked();

 private:
  termios before_{};
  ScreenSize painted_size_;
  std::vector<std::string> painted_;
};

}  // namespace bimodal::runner

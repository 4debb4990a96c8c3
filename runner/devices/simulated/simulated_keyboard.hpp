#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "runner/devices/clock.hpp"
#include "runner/devices/keyboard.hpp"

namespace bimodal::runner {

/// Types expected answers by itself, on whatever clock: the first key comes 600 ms after the answer
/// was awaited, each further one 120 ms later, then Enter. An empty answer is Enter alone. An
/// answer that is chosen is one stroke.
class SimulatedKeyboard final : public Keyboard {
 public:
  struct Options {
    Duration first_key = std::chrono::milliseconds{600};
    Duration between_keys = std::chrono::milliseconds{120};
    /// Answers that are not typed letter by letter but given by one stroke; the stroke's instant
    /// and source do not count.
    std::map<std::string, Keystroke, std::less<>> choices;
    bool confirms_choice = false;  ///< Enter follows such a stroke
  };

  /// `clock` is borrowed and must outlive the keyboard.
  explicit SimulatedKeyboard(const Clock& clock);
  SimulatedKeyboard(const Clock& clock, const Options& options);

  /// The keys that are due, each with the instant at which it was due.
  [[nodiscard]] std::vector<Keystroke> poll() override;

  /// One key per character of `answer` (UTF-8). What is left of an earlier answer is not typed.
  void expect(std::string_view answer, Instant from) override;

  [[nodiscard]] std::string description() const override;

 private:
  void plan(Keystroke stroke, Instant& at);

  const Clock& clock_;  ///< borrowed
  Options options_;
  std::vector<Keystroke> planned_;
  std::size_t typed_ = 0;
};

}  // namespace bimodal::runner

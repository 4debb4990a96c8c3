#pragma once

#include <cstddef>

#include "runner/devices/clock.hpp"
#include "runner/devices/keyboard.hpp"

namespace bimodal::runner {

/// Types expected answers by itself, on whatever clock: the first key comes 600 ms after the answer
/// was awaited, each further one 120 ms later, then Enter. An empty answer is Enter alone.
class SimulatedKeyboard final : public Keyboard {
 public:
  struct Options {
    Duration first_key = std::chrono::milliseconds{600};
    Duration between_keys = std::chrono::milliseconds{120};
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
  const Clock& clock_;  ///< borrowed
  Options options_;
  std::vector<Keystroke> planned_;
  std::size_t typed_ = 0;
};

}  // namespace bimodal::runner

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// One event that other equipment is to be told of. Names are borrowed: they outlive the session.
struct TriggerSignal {
  std::string_view event;      ///< "visual_zero"
  std::string_view condition;  ///< of the trial
  int trial = 0;               ///< as in the data, from 0
  std::uint8_t code = 0;       ///< the byte that stands for it; 0: none
  Instant planned;             ///< when it is to be sent; in the past: at once
};

/// A way to other equipment. After construction it is used by one thread, a sender's, and never
/// keeps it for more than a tenth of a second.
class TriggerPort {
 public:
  TriggerPort() = default;
  TriggerPort(const TriggerPort&) = delete;
  TriggerPort& operator=(const TriggerPort&) = delete;
  TriggerPort(TriggerPort&&) = delete;
  TriggerPort& operator=(TriggerPort&&) = delete;
  virtual ~TriggerPort() = default;

  /// Sends; false if the equipment cannot be reached. `now`: just before.
  [[nodiscard]] virtual bool send(const TriggerSignal& signal, Instant now) = 0;

  /// How long after a signal reset() is due; absent: never.
  [[nodiscard]] virtual std::optional<Duration> reset_after() const { return std::nullopt; }

  /// Takes the last signal back; false if the equipment cannot be reached.
  [[nodiscard]] virtual bool reset() { return true; }

  [[nodiscard]] virtual std::string_view kind() const = 0;    ///< "serial", "socket"
  [[nodiscard]] virtual std::string description() const = 0;  ///< "serial port /dev/ttyUSB0, ..."
};

}  // namespace bimodal::runner

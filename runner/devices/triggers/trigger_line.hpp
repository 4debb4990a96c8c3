#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "runner/devices/triggers/trigger_port.hpp"

namespace bimodal::runner {

/// What became of one signal.
struct TriggerReport {
  TriggerSignal signal;
  std::optional<Instant> sent;  ///< absent: the equipment could not be reached
  Duration uncertainty{};       ///< it left at most so long before `sent`
};

/// Takes signals from the presenting thread without ever keeping it waiting. Used by that thread.
class TriggerLine {
 public:
  TriggerLine() = default;
  TriggerLine(const TriggerLine&) = delete;
  TriggerLine& operator=(const TriggerLine&) = delete;
  TriggerLine(TriggerLine&&) = delete;
  TriggerLine& operator=(TriggerLine&&) = delete;
  virtual ~TriggerLine() = default;

  /// Sends the signal at its instant; false if too many are waiting. No lock, no allocation.
  [[nodiscard]] virtual bool post(const TriggerSignal& signal) noexcept = 0;

  /// The oldest report that was not taken yet.
  [[nodiscard]] virtual std::optional<TriggerReport> next_report() noexcept = 0;

  [[nodiscard]] virtual std::string_view kind() const = 0;    ///< of its port
  [[nodiscard]] virtual std::string description() const = 0;  ///< of its port
};

}  // namespace bimodal::runner

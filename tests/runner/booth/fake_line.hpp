#pragma once

#include <vector>

#include "runner/devices/triggers/trigger_line.hpp"

namespace bimodal::runner {

/// Keeps every signal, and reports it as sent 30 us after its instant unless it is lost.
class FakeLine final : public TriggerLine {
 public:
  explicit FakeLine(std::string_view kind) : kind_{kind} { signals.reserve(kRoom); }

  [[nodiscard]] bool post(const TriggerSignal& signal) noexcept override {
    if (signals.size() == kRoom) return false;
    signals.push_back(signal);
    return true;
  }

  [[nodiscard]] std::optional<TriggerReport> next_report() noexcept override {
    using namespace std::chrono_literals;
    if (silent || reported_ == signals.size()) return std::nullopt;
    const auto& signal = signals[reported_++];
    TriggerReport report{.signal = signal};
    if (lost) return report;
    report.sent = signal.planned + 30us;
    report.uncertainty = 20us;
    return report;
  }

  [[nodiscard]] std::string_view kind() const override { return kind_; }

  [[nodiscard]] std::string description() const override { return "a line"; }

  void forget() {
    signals.clear();
    reported_ = 0;
  }

  bool lost = false;    ///< the equipment cannot be reached
  bool silent = false;  ///< nothing is ever reported
  std::vector<TriggerSignal> signals;

 private:
  static constexpr std::size_t kRoom = 64;

  std::string_view kind_;
  std::size_t reported_ = 0;
};

}  // namespace bimodal::runner

#pragma once

#include "runner/devices/serial/serial_line.hpp"
#include "runner/devices/triggers/trigger_port.hpp"

namespace bimodal::runner {

/// Tells events by the bytes that stand for them.
class SerialPort final : public TriggerPort {
 public:
  struct Options {
    std::string port;  ///< "/dev/ttyUSB0"
    int baud = 115'200;
    std::optional<Duration> reset_after;  ///< then the byte 0 follows
  };

  /// Throws DeviceError as SerialLine does.
  explicit SerialPort(const Options& options)
      : options_{options}, line_{options.port, options.baud} {}

  /// A signal without a code is not sent.
  [[nodiscard]] bool send(const TriggerSignal& signal, Instant /*now*/) override {
    return signal.code == 0 || line_.write(signal.code);
  }

  [[nodiscard]] std::optional<Duration> reset_after() const override {
    return options_.reset_after;
  }

  [[nodiscard]] bool reset() override { return line_.write(0); }

  [[nodiscard]] std::string_view kind() const override { return "serial"; }

  [[nodiscard]] std::string description() const override {
    return "serial port " + options_.port + ", " + std::to_string(options_.baud) +
           " bits per second";
  }

 private:
  Options options_;
  SerialLine line_;
};

}  // namespace bimodal::runner

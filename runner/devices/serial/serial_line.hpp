#pragma once

#include <memory>
#include <string>
#include <vector>

namespace bimodal::runner {

/// The serial ports of this machine, as "/dev/ttyUSB0 (USB-Serial Controller)".
[[nodiscard]] std::vector<std::string> describe_serial_ports();

/// An open serial port: 8 data bits, no parity, 1 stop bit, no flow control, nothing changed on the
/// way. Also a pseudo-terminal, by which programs stand in for one.
class SerialLine {
 public:
  /// Throws DeviceError if there is no such port, it may not be used, or cannot be so fast.
  SerialLine(const std::string& port, int baud);
  ~SerialLine();
  SerialLine(const SerialLine&) = delete;
  SerialLine& operator=(const SerialLine&) = delete;
  SerialLine(SerialLine&&) = delete;
  SerialLine& operator=(SerialLine&&) = delete;

  /// Hands a byte to the driver; waits at most 100 ms for room. False if it did not take it.
  [[nodiscard]] bool write(unsigned char byte) const noexcept;

 private:
  class Port;
  std::unique_ptr<Port> port_;
};

}  // namespace bimodal::runner

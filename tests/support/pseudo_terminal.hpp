#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace bimodal {

/// A pair of ends, the nearer of which stands in for a serial port.
class PseudoTerminal {
 public:
  PseudoTerminal() : far_end_{posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)} {
    if (far_end_ < 0 || grantpt(far_end_) != 0 || unlockpt(far_end_) != 0) {
      throw std::runtime_error{"no pseudo-terminal"};
    }
    std::array<char, 64> name{};
    if (ptsname_r(far_end_, name.data(), name.size()) != 0) throw std::runtime_error{"no name"};
    port_ = name.data();
  }

  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  PseudoTerminal(PseudoTerminal&&) = delete;
  PseudoTerminal& operator=(PseudoTerminal&&) = delete;

  ~PseudoTerminal() { unplug(); }

  [[nodiscard]] const std::string& port() const { return port_; }

  /// The next `count` bytes that arrive at the far end; fewer if none comes for 10 s.
  [[nodiscard]] std::string arrived(std::size_t count) const {
    std::string bytes;
    while (bytes.size() < count) {
      pollfd ready{.fd = far_end_, .events = POLLIN, .revents = 0};
      constexpr int kPatienceMs = 10'000;
      if (poll(&ready, 1, kPatienceMs) <= 0) break;
      std::array<char, 64> part{};
      const auto size = read(far_end_, part.data(), std::min(part.size(), count - bytes.size()));
      if (size <= 0) break;
      bytes.append(part.data(), static_cast<std::size_t>(size));
    }
    return bytes;
  }

  /// As when a cable is pulled out.
  void unplug() {
    if (far_end_ >= 0) close(far_end_);
    far_end_ = -1;
  }

 private:
  int far_end_;
  std::string port_;
};

}  // namespace bimodal

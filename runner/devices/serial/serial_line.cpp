#include "runner/devices/serial/serial_line.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

#include <fcntl.h>
#include <fmt/format.h>
#include <libserialport.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <termios.h>
#include <unistd.h>

#include "runner/devices/device_error.hpp"

namespace bimodal::runner {

namespace {

constexpr int kPatienceMs = 100;

[[noreturn]] void refuse(const std::string& port, std::string_view deed, std::string_view reason) {
  throw DeviceError{fmt::format(
      "cannot {} the serial port '{}': {}; connect it, see `bimodal devices` for those that there "
      "are, mend /triggers/serial, or run without triggers by --no-triggers",
      deed,
      port,
      reason)};
}

std::string reason_of(sp_return failure) {
  if (failure == SP_ERR_ARG) return "there is no such port";
  if (failure == SP_ERR_SUPP) return "the port does not support it";
  const int code = sp_last_error_code();
  if (code == EACCES) return "you may not use it; join the group that may, mostly 'dialout'";
  return std::strerror(code);
}

/// libserialport leaves these to others: they have no modem lines and no place in /sys/class/tty.
bool is_pseudo_terminal(const std::string& path) {
  constexpr unsigned kFirstMajor = 136;  // Linux: UNIX98 slaves
  constexpr unsigned kLastMajor = 143;

  struct stat found {};

  if (::stat(path.c_str(), &found) != 0 || !S_ISCHR(found.st_mode)) return false;
  return major(found.st_rdev) >= kFirstMajor && major(found.st_rdev) <= kLastMajor;
}

int open_pseudo_terminal(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) refuse(path, "open", std::strerror(errno));
  termios settings{};
  if (::tcgetattr(descriptor, &settings) == 0) {
    ::cfmakeraw(&settings);
    ::tcsetattr(descriptor, TCSANOW, &settings);
  }
  return descriptor;
}

/// Links such as those in /dev/serial/by-id lead to names that libserialport knows.
std::string device_of(const std::string& port) {
  std::error_code ignored;
  const auto device = std::filesystem::canonical(port, ignored);
  return device.empty() ? port : device.string();
}

}  // namespace

/// Closes what it opened.
class SerialLine::Port {
 public:
  Port(const std::string& port, int baud) {
    if (is_pseudo_terminal(port)) {
      descriptor_ = open_pseudo_terminal(port);
    } else {
      open(port, baud);
    }
  }

  ~Port() {
    if (port_ == nullptr) {
      ::close(descriptor_);
    } else {
      close();
    }
  }

  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;
  Port(Port&&) = delete;
  Port& operator=(Port&&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  void open(const std::string& port, int baud) {
    const auto found = sp_get_port_by_name(device_of(port).c_str(), &port_);
    if (found != SP_OK) refuse(port, "find", reason_of(found));
    const auto opened = sp_open(port_, SP_MODE_WRITE);
    if (opened != SP_OK) {
      const auto reason = reason_of(opened);
      sp_free_port(port_);
      refuse(port, "open", reason);
    }
    auto done = sp_set_baudrate(port_, baud);
    if (done == SP_OK) done = sp_set_bits(port_, 8);
    if (done == SP_OK) done = sp_set_parity(port_, SP_PARITY_NONE);
    if (done == SP_OK) done = sp_set_stopbits(port_, 1);
    if (done == SP_OK) done = sp_set_flowcontrol(port_, SP_FLOWCONTROL_NONE);
    if (done != SP_OK) {
      const auto reason = reason_of(done);
      close();
      refuse(port, fmt::format("set {} bits per second, 8N1, on", baud), reason);
    }
    sp_get_port_handle(port_, &descriptor_);
  }

  void close() {
    sp_close(port_);
    sp_free_port(port_);
  }

  sp_port* port_ = nullptr;  ///< null: a pseudo-terminal
  int descriptor_ = -1;
};

SerialLine::SerialLine(const std::string& port, int baud)
    : port_{std::make_unique<Port>(port, baud)} {}

SerialLine::~SerialLine() = default;

bool SerialLine::write(unsigned char byte) const noexcept {
  while (true) {
    const auto written = ::write(port_->descriptor(), &byte, 1);
    if (written == 1) return true;
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno != EAGAIN) return false;
    pollfd room{.fd = port_->descriptor(), .events = POLLOUT, .revents = 0};
    if (::poll(&room, 1, kPatienceMs) <= 0 || (room.revents & POLLOUT) == 0) return false;
  }
}

std::vector<std::string> describe_serial_ports() {
  std::vector<std::string> ports;
  sp_port** list = nullptr;
  if (sp_list_ports(&list) != SP_OK) return ports;
  for (auto** port = list; *port != nullptr; ++port) {
    const char* const about = sp_get_port_description(*port);
    ports.push_back(about == nullptr ? std::string{sp_get_port_name(*port)}
                                     : fmt::format("{} ({})", sp_get_port_name(*port), about));
  }
  sp_free_port_list(list);
  return ports;
}

}  // namespace bimodal::runner

#include "runner/cli/terminal.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <string_view>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace bimodal::runner {

namespace {

std::atomic<bool> leaving = false;

void write_out(std::string_view text) {
  while (!text.empty()) {
    const auto written = ::write(STDOUT_FILENO, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      leaving = true;
      return;
    }
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void leave_at(int signal) {
  struct sigaction action {};

  action.sa_handler = [](int) { leaving = true; };
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

bool Terminal::is_there() {
  return ::isatty(STDIN_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1;
}

Terminal::Terminal() {
  ::tcgetattr(STDIN_FILENO, &before_);
  auto raw = before_;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ISIG);
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 0;
  ::tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  leave_at(SIGTERM);
  leave_at(SIGHUP);
  std::fflush(stdout);
  write_out("\x1b[?1049h\x1b[?25l\x1b[2J");  // alternate screen, no cursor, empty
}

Terminal::~Terminal() {
  write_out("\x1b[?25h\x1b[?1049l");
  ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

ScreenSize Terminal::size() const {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) {
    return {};
  }
  return {.columns = size.ws_col, .rows = size.ws_row};
}

void Terminal::paint(const std::vector<std::string>& rows) {
  const auto now = size();
  std::string text;
  if (now.columns != painted_size_.columns || now.rows != painted_size_.rows) {
    text += "\x1b[2J";
    painted_.clear();
    painted_size_ = now;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i < painted_.size() && painted_[i] == rows[i]) continue;
    text += fmt::format("\x1b[{};1H{}\x1b[K", i + 1, rows[i]);
  }
  if (painted_.size() > rows.size()) text += fmt::format("\x1b[{};1H\x1b[J", rows.size() + 1);
  painted_ = rows;
  write_out(text);
}

std::optional<char> Terminal::key() const {
  std::array<char, 64> bytes{};
  const auto count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
  if (count != 1) return std::nullopt;
  return bytes[0];
}

bool Terminal::leave_asked() {
  return leaving;
}

}  // namespace bimodal::runner

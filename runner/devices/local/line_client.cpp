#include "runner/devices/local/line_client.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include <poll.h>
#include <sys/socket.h>

#include "runner/devices/local/local_socket.hpp"

namespace bimodal::runner {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kLongestLine = 1UL << 20U;

}  // namespace

std::optional<LineClient> LineClient::connect(const std::filesystem::path& socket) {
  auto connected = connect_to(socket);
  if (!connected) return std::nullopt;
  return LineClient{std::move(*connected)};
}

LineClient::LineClient(Descriptor socket) : socket_{std::move(socket)}, splitter_{kLongestLine} {}

std::optional<std::string> LineClient::next_line(std::chrono::milliseconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (lines_.empty() && !ended_) {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    pollfd polled{.fd = socket_.number(), .events = POLLIN, .revents = 0};
    const int ready = ::poll(&polled, 1, static_cast<int>(std::max(left, 0ms).count()));
    if (ready == 0 || (ready < 0 && errno != EINTR)) break;
    if (ready > 0) receive();
  }
  if (lines_.empty()) return std::nullopt;
  auto line = std::move(lines_.front());
  lines_.pop_front();
  return line;
}

void LineClient::receive() {
  constexpr std::size_t kPart = 16UL << 10U;
  std::array<char, kPart> bytes{};
  const auto count = ::recv(socket_.number(), bytes.data(), bytes.size(), MSG_DONTWAIT);
  const bool passing = count < 0 && (errno == EAGAIN || errno == EINTR);
  ended_ = count <= 0 && !passing;
  if (count <= 0) return;
  splitter_.feed({bytes.data(), static_cast<std::size_t>(count)},
                 [this](LineSplitter::Verdict verdict, std::string_view line) {
                   if (verdict == LineSplitter::Verdict::Fine) lines_.emplace_back(line);
                 });
}

bool LineClient::send(std::string_view line) {
  const auto bytes = std::string{line} + "\n";
  return ::send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT) ==
         static_cast<ssize_t>(bytes.size());
}

}  // namespace bimodal::runner

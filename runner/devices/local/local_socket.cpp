#include "runner/devices/local/local_socket.hpp"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include "runner/devices/device_error.hpp"

namespace bimodal::runner {

namespace {

constexpr mode_t kOwnerOnly = 0600;
constexpr int kWaitingClients = 8;

std::string reason() {
  return std::error_code{errno, std::generic_category()}.message();
}

sockaddr_un address_of(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.c_str(), path.native().size());
  return address;
}

Descriptor unix_socket() {
  return Descriptor{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)};
}

/// Connecting waits so long at most where many do at once.
void set_patience(const Descriptor& socket) {
  const timeval second{.tv_sec = 1, .tv_usec = 0};
  ::setsockopt(socket.number(), SOL_SOCKET, SO_SNDTIMEO, &second, sizeof second);
}

bool stop_blocking(const Descriptor& socket) {
  return ::fcntl(socket.number(), F_SETFL, O_NONBLOCK) == 0;
}

bool call_connect(const Descriptor& socket, const std::filesystem::path& path) {
  const auto address = address_of(path);
  return ::connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) ==
         0;
}

/// Whether this user runs the other end.
bool is_same_user(const Descriptor& socket) {
  ucred peer{};
  socklen_t size = sizeof peer;
  return ::getsockopt(socket.number(), SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 &&
         peer.uid == ::geteuid();
}

}  // namespace

bool fits_socket(const std::filesystem::path& path) {
  return path.native().size() < sizeof(sockaddr_un::sun_path);
}

std::optional<Descriptor> connect_to(const std::filesystem::path& path) {
  if (!fits_socket(path)) return std::nullopt;
  auto socket = unix_socket();
  set_patience(socket);
  const bool connected = call_connect(socket, path) && is_same_user(socket);
  if (!connected || !stop_blocking(socket)) return std::nullopt;
  return socket;
}

ListeningSocket::ListeningSocket(std::filesystem::path path) : path_{std::move(path)} {
  if (!fits_socket(path_)) {
    throw DeviceError{fmt::format(
        "cannot listen at '{}': a socket's path has at most {} bytes, this one {}; choose a "
        "shorter folder",
        path_.string(),
        sizeof(sockaddr_un::sun_path) - 1,
        path_.native().size())};
  }
  replace_stale();
  socket_ = unix_socket();
  // Linux gives the file the mode of the socket, so that it is never open to others.
  if (!stop_blocking(socket_) || ::fchmod(socket_.number(), kOwnerOnly) != 0) {
    throw DeviceError{fmt::format("cannot listen at '{}': {}", path_.string(), reason())};
  }
  const auto address = address_of(path_);
  if (::bind(socket_.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw DeviceError{fmt::format(
        "cannot listen at '{}': {}; choose a folder that you may write to, on a disk that can "
        "have sockets",
        path_.string(),
        reason())};
  }

  struct stat state {};

  if (::stat(path_.c_str(), &state) == 0) {
    device_ = state.st_dev;
    inode_ = state.st_ino;
  }
  if (::listen(socket_.number(), kWaitingClients) != 0) {
    throw DeviceError{fmt::format("cannot listen at '{}': {}", path_.string(), reason())};
  }
}

ListeningSocket::~ListeningSocket() {
  if (is_ours()) ::unlink(path_.c_str());
}

bool ListeningSocket::is_ours() const {
  struct stat state {};

  return inode_ != 0 && ::stat(path_.c_str(), &state) == 0 && state.st_dev == device_ &&
         state.st_ino == inode_;
}

void ListeningSocket::replace_stale() {
  struct stat state {};

  if (::lstat(path_.c_str(), &state) != 0) return;
  if (!S_ISSOCK(state.st_mode)) {
    throw DeviceError{fmt::format(
        "cannot listen at '{}': something else has this name; move it away", path_.string())};
  }
  const auto tried = unix_socket();
  if (!stop_blocking(tried)) {
    throw DeviceError{fmt::format("cannot listen at '{}': {}", path_.string(), reason())};
  }
  if (call_connect(tried, path_) || errno != ECONNREFUSED) {
    throw DeviceError{fmt::format(
        "cannot listen at '{}': another program does already; end it first", path_.string())};
  }
  ::unlink(path_.c_str());
}

ListeningSocket::Accepted ListeningSocket::accept() const {
  Descriptor client{::accept4(socket_.number(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK)};
  if (!client.is_open()) {
    const bool passing = errno == EAGAIN || errno == EINTR || errno == ECONNABORTED;
    return {.client = {}, .exhausted = !passing};
  }
  if (!is_same_user(client)) return {};
  return {.client = std::move(client)};
}

}  // namespace bimodal::runner

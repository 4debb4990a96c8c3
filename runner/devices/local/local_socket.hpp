#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "runner/devices/local/descriptor.hpp"

namespace bimodal::runner {

/// Whether a path fits into the address of a Unix socket (107 bytes on Linux).
[[nodiscard]] bool fits_socket(const std::filesystem::path& path);

/// A Unix stream socket connected to whoever listens at `path`, not blocking. Nothing: nobody does
/// (no file, or that of a dead process), or it is another user, whom we do not believe.
[[nodiscard]] std::optional<Descriptor> connect_to(const std::filesystem::path& path);

/// A Unix stream socket at which this user's programs can connect. The file (mode 0600 from its
/// first moment) goes with it. For one thread.
class ListeningSocket {
 public:
  /// Replaces the file of a process that has died. Throws DeviceError if somebody listens at `path`
  /// already, if something other than a socket is there, if the path is too long for a socket, or
  /// if its folder cannot have one.
  explicit ListeningSocket(std::filesystem::path path);
  ~ListeningSocket();
  ListeningSocket(const ListeningSocket&) = delete;
  ListeningSocket& operator=(const ListeningSocket&) = delete;
  ListeningSocket(ListeningSocket&&) = delete;
  ListeningSocket& operator=(ListeningSocket&&) = delete;

  /// Becomes readable when somebody connects.
  [[nodiscard]] int number() const { return socket_.number(); }

  struct Accepted {
    Descriptor client;       ///< not blocking; closed: nobody, or another user, who was refused
    bool exhausted = false;  ///< the system has no more descriptors: asking again at once is vain
  };

  [[nodiscard]] Accepted accept() const;

 private:
  void replace_stale();
  [[nodiscard]] bool is_ours() const;

  std::filesystem::path path_;
  Descriptor socket_;
  unsigned long device_ = 0;  ///< of the file, by which it is known again
  unsigned long inode_ = 0;
};

}  // namespace bimodal::runner

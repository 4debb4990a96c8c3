#pragma once

#include <chrono>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "runner/devices/local/descriptor.hpp"
#include "runner/devices/local/line_splitter.hpp"

namespace bimodal::runner {

/// The other side of a LineServer. For one thread.
class LineClient {
 public:
  /// Nothing: nobody of this user listens at `socket`.
  [[nodiscard]] static std::optional<LineClient> connect(const std::filesystem::path& socket);

  /// Becomes readable when lines have come.
  [[nodiscard]] int number() const { return socket_.number(); }

  /// The next line, for which it waits at most `patience`; nothing: none came in this time, or the
  /// server has gone. Lines that are overlong (1 MiB) or no UTF-8 are passed over.
  [[nodiscard]] std::optional<std::string> next_line(std::chrono::milliseconds patience);

  /// Whether the server has gone and all that it sent has been taken.
  [[nodiscard]] bool has_ended() const { return ended_ && lines_.empty(); }

  /// Sends a line; false: the server has gone, or does not read.
  bool send(std::string_view line);

 private:
  explicit LineClient(Descriptor socket);
  void receive();

  Descriptor socket_;
  LineSplitter splitter_;
  std::deque<std::string> lines_;
  bool ended_ = false;
};

}  // namespace bimodal::runner

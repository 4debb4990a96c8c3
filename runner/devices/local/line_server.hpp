#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace bimodal::runner {

/// A line that a client sent.
struct ReceivedLine {
  std::uint32_t client = 0;  ///< from 1; never given twice
  std::string text;          ///< UTF-8 without the line break, not empty
};

/// How much a client may cost us, and what it is told first.
struct LineServerOptions {
  std::size_t longest_line = 4096;         ///< bytes that a client may send at a time
  std::size_t most_clients = 16;           ///< at the same time
  std::size_t most_unread = 256UL << 10U;  ///< bytes for one client, beside the system's own
  std::size_t hand_over = 256UL << 10U;    ///< bytes published and not yet sent; a power of two
  std::string welcome{};  ///< told to new clients after the newest lines; empty: nothing
};

/// Tells lines of text to whoever of this user's programs connects to a Unix stream socket, and
/// takes lines from them. A thread of its own does the work: whoever publishes never waits for a
/// client, and a client that does not read is dropped.
///
/// All members are for one thread, that of the session (any one, always the same).
class LineServer {
 public:
  /// Listens at `socket` (a file of mode 0600, gone when the server ends). Throws DeviceError as
  /// ListeningSocket does.
  explicit LineServer(const std::filesystem::path& socket, const LineServerOptions& options = {});

  /// Sends what was published, waiting for clients that read at most 200 ms.
  ~LineServer();
  LineServer(const LineServer&) = delete;
  LineServer& operator=(const LineServer&) = delete;
  LineServer(LineServer&&) = delete;
  LineServer& operator=(LineServer&&) = delete;

  /// Hands a line (UTF-8, without line break) over for all clients. It is kept as the newest of
  /// its kind, and whoever connects later gets the newest line of each kind first, in the order in
  /// which kinds first came. An empty kind is not kept. Takes microseconds, in the middle of a
  /// stimulus too: it copies the line and wakes the server's thread; no lock, no allocation. False:
  /// the line was refused, for it has a line break, or `hand_over` is full because the server's
  /// thread has not run.
  bool publish(std::string_view kind, std::string_view line) noexcept;

  /// The same for one client only; what it sent is answered. Nothing if it has left.
  bool answer(std::uint32_t client, std::string_view line) noexcept;

  /// The oldest line that a client sent and that was not taken yet. Takes no lock.
  [[nodiscard]] std::optional<ReceivedLine> next_line();

  /// Clients that are connected at the moment.
  [[nodiscard]] std::size_t clients() const noexcept;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace bimodal::runner

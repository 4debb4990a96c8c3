#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bimodal::runner {

/// Carries texts, in order, from exactly one producer thread to exactly one consumer thread.
/// `try_push` (producer only) takes no lock, allocates nothing and makes no system call: it copies
/// the text into a ring of bytes that was made beforehand, or refuses it. `try_pop` is the
/// consumer's.
class LineRing {
 public:
  struct Line {
    std::uint32_t address = 0;  ///< to or from whom; the meaning is the users'
    std::string kind;
    std::string text;
  };

  /// `capacity`: bytes, a power of two; each text needs its own size, its kind's and 12 more.
  explicit LineRing(std::size_t capacity) : bytes_(capacity) {
    assert(std::has_single_bit(capacity));
  }

  /// False: there is no room.
  [[nodiscard]] bool try_push(std::uint32_t address,
                              std::string_view kind,
                              std::string_view text) noexcept {
    const auto write = write_.load(std::memory_order_relaxed);
    const auto taken = write - read_.load(std::memory_order_acquire);
    const auto room = bytes_.size() - taken;
    if (text.size() > room || kind.size() > room) return false;  // their sum cannot overflow
    if (sizeof(Header) + kind.size() + text.size() > room) return false;
    const Header header{.address = address,
                        .kind_size = static_cast<std::uint32_t>(kind.size()),
                        .text_size = static_cast<std::uint32_t>(text.size())};
    auto at = put(write, reinterpret_cast<const char*>(&header), sizeof header);
    at = put(at, kind.data(), kind.size());
    at = put(at, text.data(), text.size());
    write_.store(at, std::memory_order_release);  // publishes the bytes to try_pop
    return true;
  }

  [[nodiscard]] std::optional<Line> try_pop() {
    const auto read = read_.load(std::memory_order_relaxed);
    if (read == write_.load(std::memory_order_acquire)) return std::nullopt;
    Header header;
    auto at = take(read, reinterpret_cast<char*>(&header), sizeof header);
    Line line{.address = header.address,
              .kind = std::string(header.kind_size, '\0'),
              .text = std::string(header.text_size, '\0')};
    at = take(at, line.kind.data(), line.kind.size());
    at = take(at, line.text.data(), line.text.size());
    read_.store(at, std::memory_order_release);  // returns the bytes to try_push
    return line;
  }

 private:
  struct Header {
    std::uint32_t address = 0;
    std::uint32_t kind_size = 0;
    std::uint32_t text_size = 0;
  };

  /// Copies to the ring from position `at` on; returns the position behind.
  std::size_t put(std::size_t at, const char* from, std::size_t size) noexcept {
    const auto place = at & (bytes_.size() - 1);
    const auto first = std::min(size, bytes_.size() - place);
    std::memcpy(bytes_.data() + place, from, first);
    std::memcpy(bytes_.data(), from + first, size - first);
    return at + size;
  }

  std::size_t take(std::size_t at, char* to, std::size_t size) const noexcept {
    const auto place = at & (bytes_.size() - 1);
    const auto first = std::min(size, bytes_.size() - place);
    std::memcpy(to, bytes_.data() + place, first);
    std::memcpy(to + first, bytes_.data(), size - first);
    return at + size;
  }

  static constexpr std::size_t kCacheLine = 64;

  std::vector<char> bytes_;
  alignas(kCacheLine) std::atomic<std::size_t> write_{0};  ///< bytes ever written
  alignas(kCacheLine) std::atomic<std::size_t> read_{0};   ///< bytes ever read
};

}  // namespace bimodal::runner

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace lab {

/// A part of the screen, in pixels from its upper left corner.
struct Region {
  int x = 0;
  int y = 0;
  int width = 8;
  int height = 8;
};

/// One refresh as the compositor showed it.
struct SeenRefresh {
  std::int64_t at_ns = 0;    ///< CLOCK_MONOTONIC: the compositor's own presentation time
  std::uint32_t levels = 0;  ///< mean brightness of up to four equal columns of the region, 8 bits
                             ///< each, the leftmost in the lowest
};

/// Captures a region of the compositor's first output at every refresh (wlr-screencopy). It knows
/// nothing of the program that draws there.
class ScreenWatch {
 public:
  /// Connects to WAYLAND_DISPLAY. `columns` is 1 to 4. Throws std::runtime_error.
  ScreenWatch(const Region& region, int columns);
  ScreenWatch(const ScreenWatch&) = delete;
  ScreenWatch& operator=(const ScreenWatch&) = delete;
  ScreenWatch(ScreenWatch&&) = delete;
  ScreenWatch& operator=(ScreenWatch&&) = delete;
  ~ScreenWatch();

  /// Watches until `stopped` says so; tells of every refresh as it happens.
  void run(const std::function<bool()>& stopped,
           const std::function<void(const SeenRefresh&)>& tell);

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace lab

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runner/devices/clock.hpp"
#include "runner/timing/clock_map.hpp"
#include "runner/timing/refresh_estimate.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// Where an instant came from, worst to best. Stored beside every onset, because an analysis may
/// only trust what was reported.
enum class TimeSource { Predicted, SwapReturned, DriverReported, Photodiode };

/// "predicted", "swap_returned", "driver_reported", "photodiode".
[[nodiscard]] std::string_view name(TimeSource source);

/// Pixels to be shown: rows from the top, red, green, blue, unused, 8 bits each. Borrowed: they
/// live in the prepared trial, and neither they nor their place changes while pictures follow each
/// other on the screen (a display may keep what it was last given and look at the address only).
struct Picture {
  std::size_t width = 0;
  std::size_t height = 0;
  std::span<const std::uint8_t> pixels{};
};

/// A block of text; '\n' breaks lines, which are centred, and long lines wrap.
struct Caption {
  std::string text;
  double centre_y = 0.5;  ///< of the window's height, from the top
  double size = 0.03;     ///< line height as a part of the window's height
  double centre_x = 0.5;  ///< of the window's width
};

/// A coloured disc or box. Places are parts of the window's width (x) and height (y, from the top).
struct Mark {
  enum class Shape { Disc, Box };
  Shape shape = Shape::Box;
  double centre_x = 0.5;
  double centre_y = 0.5;
  double width = 0.0;   ///< of a box, as a part of the window's width
  double height = 0.0;  ///< of a box, or a disc's diameter, as a part of the window's height
  std::array<float, 3> colour{};  ///< red, green, blue, each from 0 to 1
};

/// Everything that is on the screen at one refresh.
struct Screen {
  const Picture* picture = nullptr;  ///< in the middle of the window; none: background
  bool fixation = false;             ///< a cross in the middle
  std::vector<Caption> captions{};
  double progress = -1.0;     ///< part of the session done, as a bar at the bottom; < 0: no bar
  std::vector<Mark> marks{};  ///< in this order, below the captions
  /// The stimulus's time zero is seen here first: a patch for a photodiode changes now.
  bool at_zero = false;
};

/// What became of one requested refresh.
struct Presentation {
  Instant onset;  ///< the refresh at which the screen appeared
  TimeSource source = TimeSource::Predicted;
  Duration lateness{};  ///< onset minus deadline, > half a period when a refresh was missed
  /// The refresh of that onset, counted by the screen since some origin: pictures meant for
  /// consecutive refreshes whose counts differ by 2 missed one. Absent: nobody counts them.
  std::optional<std::uint64_t> refresh{};
};

/// A screen that shows prepared pictures at refresh boundaries. Used by one thread.
class Display {
 public:
  Display() = default;
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;
  Display(Display&&) = delete;
  Display& operator=(Display&&) = delete;
  virtual ~Display() = default;

  /// Shows `screen` at the first refresh not earlier than `deadline` (less half a period, so that a
  /// deadline on the refresh grid meets its refresh); blocks until it has been shown. A deadline in
  /// the past means the next refresh.
  virtual Presentation present(const Screen& screen, Instant deadline) = 0;

  /// Lets time pass until the session clock reads `until`, taking in what is typed meanwhile; what
  /// is shown stays.
  virtual void wait(Instant until) = 0;

  /// Measured at start-up over at least 100 refreshes, refined with every presentation.
  [[nodiscard]] virtual RefreshEstimate refresh() const = 0;

  /// Refreshes since the first measured one on the session clock; absent where nothing is measured.
  [[nodiscard]] virtual std::optional<DeviceClock> clock() const { return std::nullopt; }

  [[nodiscard]] virtual std::string kind() const = 0;         ///< "sdl", "headless", "simulated"
  [[nodiscard]] virtual std::string description() const = 0;  ///< driver, renderer, size, period
  [[nodiscard]] virtual TimeSource time_source() const = 0;
};

}  // namespace bimodal::runner

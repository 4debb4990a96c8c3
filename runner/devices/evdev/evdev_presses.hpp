#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// A key or button that went down, as the kernel saw it.
struct KernelPress {
  std::uint32_t code = 0;  ///< of linux/input-event-codes.h: KEY_A, BTN_LEFT
  Instant at;              ///< session clock, whole microseconds, rounded down
};

/// The kernel's own stamps of keys and buttons (Linux evdev), which no window system has rounded or
/// delayed. They come from all input devices that may be read (as root, or in the group `input`),
/// whichever window has the keyboard, so they are only used to date what the window was given: of
/// each press nothing but code and instant is kept, and that only until the next call. Devices
/// plugged in later are not noticed. For one thread.
class EvdevPresses {
 public:
  static constexpr std::size_t kMostDevices = 32;
  static constexpr Duration kGrain = std::chrono::microseconds{1};

  /// Opens all devices in `folder` that have keys or buttons, may be read, and can stamp by
  /// CLOCK_MONOTONIC.
  explicit EvdevPresses(const std::filesystem::path& folder = "/dev/input");

  /// Reads from `descriptors`, which it closes in the end: non-blocking, and set to
  /// CLOCK_MONOTONIC.
  explicit EvdevPresses(std::vector<int> descriptors);

  EvdevPresses(const EvdevPresses&) = delete;
  EvdevPresses& operator=(const EvdevPresses&) = delete;
  EvdevPresses(EvdevPresses&&) = delete;
  EvdevPresses& operator=(EvdevPresses&&) = delete;
  ~EvdevPresses();

  /// What was pressed since the last call, by device and in order, at most 64 (more wait); valid
  /// until the next call. What a device had to drop is lost; a device that is gone is left out.
  [[nodiscard]] std::span<const KernelPress> collect();

  /// Devices that are read.
  [[nodiscard]] std::size_t devices() const { return descriptors_.size(); }

  /// Why there are none; empty: there are some.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }

 private:
  static constexpr std::size_t kMostPresses = 64;

  [[nodiscard]] bool read_from(int descriptor);

  std::vector<int> descriptors_;
  std::string refusal_;
  std::array<KernelPress, kMostPresses> presses_{};
  std::size_t count_ = 0;
};

}  // namespace bimodal::runner

#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "stimuli/base/quantity.hpp"

struct wl_display;

namespace bimodal::runner {

/// A key or button that went down, as the compositor tells its clients.
struct SeatPress {
  std::uint32_t code = 0;          ///< of linux/input-event-codes.h: KEY_A, BTN_LEFT
  std::uint32_t milliseconds = 0;  ///< "with an undefined base": of compositors on libinput the
                                   ///< kernel's stamp on CLOCK_MONOTONIC, rounded down; of virtual
                                   ///< keyboards whatever their program says, such as 0
};

/// The stamps that SDL 2 drops: keyboard and pointer of the first seat, bound once more on SDL's
/// connection, with an event queue of our own. For SDL's thread.
class SeatPresses {
 public:
  static constexpr Duration kGrain = std::chrono::milliseconds{1};

  /// `display` is borrowed and must outlive this.
  explicit SeatPresses(wl_display* display);
  SeatPresses(const SeatPresses&) = delete;
  SeatPresses& operator=(const SeatPresses&) = delete;
  SeatPresses(SeatPresses&&) = delete;
  SeatPresses& operator=(SeatPresses&&) = delete;
  ~SeatPresses();

  /// What was pressed since the last call, of what SDL's pump has read from the connection, in
  /// order, at most the first 64; valid until the next call.
  [[nodiscard]] std::span<const SeatPress> collect();

  /// Whether the compositor has a seat at all.
  [[nodiscard]] bool has_seat() const;

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace bimodal::runner

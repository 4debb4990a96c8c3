#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <SDL.h>

#include "runner/devices/clock.hpp"
#include "runner/devices/sdl/sdl_window.hpp"

namespace bimodal::runner {

/// What an X server says about one of its events.
struct ServerWord {
  std::uint32_t milliseconds = 0;  ///< the server's time
  std::uint32_t code = 0;          ///< of linux/input-event-codes.h, for keys of this machine
  bool is_key = false;
};

/// An event of SDL, and when it was noticed.
struct NoticedEvent {
  SDL_Event event{};
  Instant at;            ///< when SDL queued it
  Duration unnoticed{};  ///< so long before it had not come yet
  std::optional<ServerWord> server{};
};

/// Stamps the events that matter to a session at the moment at which SDL takes them in, that is
/// inside the pump, by a watch (SDL_AddEventWatch), and keeps them until they are asked for. SDL's
/// own stamps are whole milliseconds of the same moment. For SDL's thread.
class NoticedEvents {
 public:
  static constexpr std::size_t kMost = 256;

  /// Both are borrowed and must outlive this.
  NoticedEvents(const SdlWindow& window, const Clock& clock);
  NoticedEvents(const NoticedEvents&) = delete;
  NoticedEvents& operator=(const NoticedEvents&) = delete;
  NoticedEvents(NoticedEvents&&) = delete;
  NoticedEvents& operator=(NoticedEvents&&) = delete;
  ~NoticedEvents();

  /// Keys and text, clicks, buttons, devices plugged in, the window closed or left by the keyboard:
  /// since the last forget(), in order. Beyond 256 they are lost.
  [[nodiscard]] std::span<const NoticedEvent> events() const {
    return std::span{ring_}.first(count_);
  }

  void forget() { count_ = 0; }

 private:
  static int on_event(void* self, SDL_Event* event);
  void notice(const SDL_Event& event);
  void hear_server(const SDL_Event& event);

  const SdlWindow& window_;  ///< borrowed
  const Clock& clock_;       ///< borrowed
  std::array<NoticedEvent, kMost> ring_{};
  std::size_t count_ = 0;
  std::optional<ServerWord> server_;  ///< about what SDL is taking in at present
};

}  // namespace bimodal::runner

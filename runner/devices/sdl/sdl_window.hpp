#pragma once

#include <array>
#include <memory>
#include <string>

#include "runner/devices/monotonic_clock.hpp"
#include "stimuli/base/quantity.hpp"

struct SDL_Window;

namespace bimodal::runner {

/// Red, green, blue, each from 0 to 1, as the screen takes them (no gamma is applied).
using Colour = std::array<float, 3>;

/// One window with an OpenGL 3.3 core context that waits for every refresh. Owns SDL's video part
/// and this thread's context: only one may exist, and only the thread that made it may use it.
class SdlWindow {
 public:
  struct Options {
    int width = 1280;  ///< pixels; not used in full screen
    int height = 1024;
    bool fullscreen = false;
    std::string title = "Bimodal";
    Colour background{0.5F, 0.5F, 0.5F};
  };

  /// Throws DeviceError when there is no display, or none that can do it.
  explicit SdlWindow(Options options);
  SdlWindow(const SdlWindow&) = delete;
  SdlWindow& operator=(const SdlWindow&) = delete;
  SdlWindow(SdlWindow&&) = delete;
  SdlWindow& operator=(SdlWindow&&) = delete;
  ~SdlWindow();

  struct Size {
    int width = 0;
    int height = 0;
  };

  [[nodiscard]] Size size() const;              ///< drawable pixels, now
  [[nodiscard]] Size points() const;            ///< the unit of mouse positions, now
  [[nodiscard]] static std::string driver();    ///< SDL's video driver, "wayland", "x11", ...
  [[nodiscard]] static std::string renderer();  ///< who draws, as OpenGL names it
  [[nodiscard]] Hertz nominal_rate() const;     ///< of the display mode; 60 where it says nothing

  [[nodiscard]] const Colour& background() const { return options_.background; }

  /// Hands the drawn picture over and returns when the driver has taken it.
  void swap();

  /// Takes in what has come from the window system and the devices, and lets it know that the
  /// program is alive; events stay queued. To be called every millisecond or so while waiting.
  void pump();

  /// When the pump before the present one (or, between pumps, before the last) began: what is
  /// queued in this one had not come by then.
  [[nodiscard]] Instant nothing_before() const { return previous_pump_; }

  /// The mouse cursor is hidden until it is asked for.
  static void show_pointer(bool shown);

  [[nodiscard]] SDL_Window* native() const { return window_; }

 private:
  void open();
  void close() noexcept;

  Options options_;
  SDL_Window* window_ = nullptr;
  void* context_ = nullptr;
  MonotonicClock clock_;
  Instant previous_pump_ = clock_.now();
  Instant pump_ = previous_pump_;
};

}  // namespace bimodal::runner

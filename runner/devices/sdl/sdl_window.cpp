#include "runner/devices/sdl/sdl_window.hpp"

#include <cstdlib>
#include <string_view>
#include <utility>

#include <SDL.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include "runner/devices/device_error.hpp"

namespace bimodal::runner {
namespace {

constexpr std::string_view kRemedy =
    "run it in a graphical session (DISPLAY or WAYLAND_DISPLAY set), or without a screen by "
    "--display headless";

constexpr double kUnstatedRate = 60.0;

[[noreturn]] void fail(std::string_view deed) {
  throw DeviceError{fmt::format("display: {}: {}; {}", deed, SDL_GetError(), kRemedy)};
}

/// Drivers of SDL that draw into memory only.
bool shows_nothing(std::string_view driver) {
  return driver == "dummy" || driver == "offscreen";
}

}  // namespace

SdlWindow::SdlWindow(Options options) : options_{std::move(options)} {
  try {
    open();
  } catch (...) {
    close();
    throw;
  }
}

SdlWindow::~SdlWindow() {
  close();
}

void SdlWindow::open() {
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  SDL_SetHint(SDL_HINT_VIDEO_MINIMIZE_ON_FOCUS_LOSS, "0");
  SDL_SetHint(SDL_HINT_VIDEO_DOUBLE_BUFFER, "1");  // else KMSDRM returns before the refresh
  // Where both are there, not through XWayland: that hides the refreshes. Never one without screen.
  // (Without a runtime folder there is no Wayland, and its library would complain.)
  const bool may_have_wayland = std::getenv("XDG_RUNTIME_DIR") != nullptr;
  SDL_SetHint(SDL_HINT_VIDEODRIVER, may_have_wayland ? "wayland,x11,KMSDRM" : "x11,KMSDRM");
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) fail("no display found");
  if (shows_nothing(driver())) {
    throw DeviceError{fmt::format(
        "display: SDL_VIDEODRIVER is \"{}\", which shows nothing; {}", driver(), kRemedy)};
  }
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
  const auto flags = SDL_WINDOW_OPENGL | SDL_WINDOW_ALLOW_HIGHDPI |
                     (options_.fullscreen ? SDL_WINDOW_FULLSCREEN_DESKTOP : SDL_WINDOW_RESIZABLE);
  window_ = SDL_CreateWindow(options_.title.c_str(),
                             SDL_WINDOWPOS_CENTERED,
                             SDL_WINDOWPOS_CENTERED,
                             options_.width,
                             options_.height,
                             static_cast<Uint32>(flags));
  if (window_ == nullptr) {
    fail(fmt::format("cannot open a window of {} x {}", options_.width, options_.height));
  }
  context_ = SDL_GL_CreateContext(window_);
  if (context_ == nullptr) fail("cannot make an OpenGL 3.3 context");
  SDL_GL_SetSwapInterval(1);  // whether it helps is measured, not asked
  show_pointer(false);
}

void SdlWindow::close() noexcept {
  if (context_ != nullptr) SDL_GL_DeleteContext(context_);
  if (window_ != nullptr) SDL_DestroyWindow(window_);
  if (SDL_WasInit(SDL_INIT_VIDEO) != 0) SDL_QuitSubSystem(SDL_INIT_VIDEO);
}

SdlWindow::Size SdlWindow::size() const {
  Size size;
  SDL_GL_GetDrawableSize(window_, &size.width, &size.height);
  return size;
}

SdlWindow::Size SdlWindow::points() const {
  Size size;
  SDL_GetWindowSize(window_, &size.width, &size.height);
  return size;
}

std::string SdlWindow::driver() {
  const auto* name = SDL_GetCurrentVideoDriver();
  return name != nullptr ? name : "none";
}

std::string SdlWindow::renderer() {
  const auto text = [](GLenum which) {
    const auto* found = reinterpret_cast<const char*>(glGetString(which));
    return found != nullptr ? found : "unknown";
  };
  return fmt::format("{}, OpenGL {}", text(GL_RENDERER), text(GL_VERSION));
}

Hertz SdlWindow::nominal_rate() const {
  SDL_DisplayMode mode{};
  const auto display = SDL_GetWindowDisplayIndex(window_);
  if (display < 0 || SDL_GetCurrentDisplayMode(display, &mode) != 0 || mode.refresh_rate <= 0) {
    return Hertz{kUnstatedRate};
  }
  return Hertz{static_cast<double>(mode.refresh_rate)};
}

void SdlWindow::swap() {
  SDL_GL_SwapWindow(window_);
  glFinish();  // on X11 it is here that a driver waits, not in the swap
}

void SdlWindow::pump() {
  previous_pump_ = std::exchange(pump_, clock_.now());
  SDL_PumpEvents();
}

void SdlWindow::show_pointer(bool shown) {
  SDL_ShowCursor(shown ? SDL_ENABLE : SDL_DISABLE);
}

}  // namespace bimodal::runner

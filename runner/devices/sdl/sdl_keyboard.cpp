#include "runner/devices/sdl/sdl_keyboard.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <SDL.h>
#include <fmt/format.h>

#include "runner/devices/sdl/button_boxes.hpp"
#include "runner/devices/sdl/noticed_events.hpp"
#include "runner/devices/sdl/press_stamps.hpp"

namespace bimodal::runner {
namespace {

std::optional<Key> key_of(SDL_Keycode code) {
  switch (code) {
    case SDLK_BACKSPACE:
      return Key::Backspace;
    case SDLK_RETURN:
    case SDLK_RETURN2:
    case SDLK_KP_ENTER:
      return Key::Enter;
    case SDLK_LEFT:
      return Key::Left;
    case SDLK_ESCAPE:
      return Key::Escape;
    default:
      return std::nullopt;
  }
}

/// The middle of a pixel, as a part of the window's extent.
double part_of(int position, int extent) {
  return extent > 0 ? (position + 0.5) / extent : 0.0;
}

}  // namespace

std::optional<Keystroke> keystroke_of(const SDL_Event& event,
                                      const InputStamp& stamp,
                                      SdlWindow::Size points) {
  Keystroke stroke{.at = stamp.at, .uncertainty = stamp.uncertainty, .source = stamp.source};
  switch (event.type) {
    case SDL_TEXTINPUT:
      stroke.text = std::data(event.text.text);
      return stroke;
    case SDL_KEYDOWN: {
      const auto key = key_of(event.key.keysym.sym);
      if (!key || (event.key.repeat != 0 && *key != Key::Backspace)) return std::nullopt;
      stroke.key = *key;
      return stroke;
    }
    case SDL_MOUSEBUTTONDOWN:
      stroke.key = Key::Pointer;
      stroke.button = event.button.button;
      stroke.x = part_of(event.button.x, points.width);
      stroke.y = part_of(event.button.y, points.height);
      return stroke;
    case SDL_JOYBUTTONDOWN:
      stroke.key = Key::Button;
      stroke.button = event.jbutton.button + 1;
      return stroke;
    case SDL_QUIT:
      stroke.key = Key::WindowClosed;
      return stroke;
    default:
      return std::nullopt;
  }
}

struct SdlKeyboard::Sources {
  Sources(const SdlWindow& window, const Clock& clock) : noticed{window, clock}, stamps{window} {}

  NoticedEvents noticed;  ///< before the boxes: it notices which there are
  ButtonBoxes boxes;
  PressStamps stamps;
};

SdlKeyboard::SdlKeyboard(SdlWindow& window, const Clock& clock)
    : window_{window}, clock_{clock}, sources_{std::make_unique<Sources>(window, clock)} {
  SDL_StartTextInput();
  static_cast<void>(poll());
}

SdlKeyboard::~SdlKeyboard() = default;

std::vector<Keystroke> SdlKeyboard::poll() {
  auto& [noticed, boxes, stamps] = *sources_;
  std::vector<Keystroke> keystrokes;
  window_.pump();
  stamps.collect(clock_);
  const auto points = window_.points();
  for (const auto& each : noticed.events()) {
    if (each.event.type == SDL_WINDOWEVENT) SDL_RaiseWindow(window_.native());
    if (each.event.type == SDL_JOYDEVICEADDED) boxes.open(each.event.jdevice.which);
    if (auto keystroke = keystroke_of(each.event, stamps.of(each), points)) {
      keystrokes.push_back(std::move(*keystroke));
    }
  }
  noticed.forget();
  SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);  // what matters was noticed
  return keystrokes;
}

void SdlKeyboard::expect(std::string_view /*answer*/, Instant /*from*/) {}

void SdlKeyboard::show_pointer(bool shown) {
  SdlWindow::show_pointer(shown);
}

std::string SdlKeyboard::description() const {
  return fmt::format("keyboard, mouse and button boxes through SDL ({}); instants: {}",
                     SdlWindow::driver(),
                     sources_->stamps.description());
}

}  // namespace bimodal::runner

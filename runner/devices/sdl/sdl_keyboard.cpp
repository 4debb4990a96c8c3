#include "runner/devices/sdl/sdl_keyboard.hpp"

#include <iterator>
#include <utility>

#include <SDL.h>

namespace bimodal::runner {
namespace {

constexpr std::string_view kSource = "poll";

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

}  // namespace

std::optional<Keystroke> keystroke_of(const SDL_Event& event, Instant now) {
  const auto stroke = [now](Key key, std::string text) {
    return Keystroke{.key = key, .text = std::move(text), .at = now, .source = kSource};
  };
  switch (event.type) {
    case SDL_TEXTINPUT:
      return stroke(Key::Text, std::data(event.text.text));
    case SDL_KEYDOWN: {
      const auto key = key_of(event.key.keysym.sym);
      if (!key || (event.key.repeat != 0 && *key != Key::Backspace)) return std::nullopt;
      return stroke(*key, {});
    }
    case SDL_QUIT:
      return stroke(Key::WindowClosed, {});
    default:
      return std::nullopt;
  }
}

SdlKeyboard::SdlKeyboard(SdlWindow& window, const Clock& clock) : window_{window}, clock_{clock} {
  SDL_StartTextInput();
  SDL_PumpEvents();
  SDL_FlushEvents(SDL_KEYDOWN, SDL_TEXTINPUT);
}

std::vector<Keystroke> SdlKeyboard::poll() {
  std::vector<Keystroke> keystrokes;
  SDL_Event event;
  while (SDL_PollEvent(&event) != 0) {
    if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
      SDL_RaiseWindow(window_.native());
    }
    if (auto keystroke = keystroke_of(event, clock_.now())) {
      keystrokes.push_back(std::move(*keystroke));
    }
  }
  return keystrokes;
}

void SdlKeyboard::expect(std::string_view /*answer*/, Instant /*from*/) {}

}  // namespace bimodal::runner

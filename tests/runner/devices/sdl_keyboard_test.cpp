#include "runner/devices/sdl/sdl_keyboard.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <SDL2/SDL_events.h>
#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr Instant kNow{12s};

SDL_Event key_press(SDL_Keycode code, bool repeated = false) {
  SDL_Event event{};
  event.type = SDL_KEYDOWN;
  event.key.keysym.sym = code;
  event.key.repeat = repeated ? 1 : 0;
  return event;
}

SDL_Event text_input(std::string_view text) {
  SDL_Event event{};
  event.type = SDL_TEXTINPUT;
  std::ranges::copy(text, std::data(event.text.text));
  return event;
}

TEST(KeystrokeOf, TakesTextAsUtf8WithTheInstantOfThePoll) {
  const auto keystroke = keystroke_of(text_input("é"), kNow);
  ASSERT_TRUE(keystroke);
  EXPECT_EQ(keystroke->key, Key::Text);
  EXPECT_EQ(keystroke->text, "é");
  EXPECT_EQ(keystroke->at, kNow);
  EXPECT_EQ(keystroke->source, "poll");
}

TEST(KeystrokeOf, KnowsTheEditingKeysAndBothEnterKeys) {
  EXPECT_EQ(keystroke_of(key_press(SDLK_RETURN), kNow)->key, Key::Enter);
  EXPECT_EQ(keystroke_of(key_press(SDLK_KP_ENTER), kNow)->key, Key::Enter);
  EXPECT_EQ(keystroke_of(key_press(SDLK_BACKSPACE), kNow)->key, Key::Backspace);
  EXPECT_EQ(keystroke_of(key_press(SDLK_LEFT), kNow)->key, Key::Left);
  EXPECT_EQ(keystroke_of(key_press(SDLK_ESCAPE), kNow)->key, Key::Escape);
}

TEST(KeystrokeOf, RepeatsBackspaceWhileHeldButNeitherEnterNorEscape) {
  EXPECT_TRUE(keystroke_of(key_press(SDLK_BACKSPACE, true), kNow));
  EXPECT_FALSE(keystroke_of(key_press(SDLK_RETURN, true), kNow));
  EXPECT_FALSE(keystroke_of(key_press(SDLK_KP_ENTER, true), kNow));
  EXPECT_FALSE(keystroke_of(key_press(SDLK_ESCAPE, true), kNow));
}

TEST(KeystrokeOf, TakesLettersOnlyFromTextInputSoThatNoneComesTwice) {
  EXPECT_FALSE(keystroke_of(key_press(SDLK_a), kNow));
  EXPECT_FALSE(keystroke_of(key_press(SDLK_LSHIFT), kNow));
}

TEST(KeystrokeOf, NoticesThatTheWindowIsClosed) {
  SDL_Event event{};
  event.type = SDL_QUIT;
  EXPECT_EQ(keystroke_of(event, kNow)->key, Key::WindowClosed);
  event.type = SDL_MOUSEMOTION;
  EXPECT_FALSE(keystroke_of(event, kNow));
}

}  // namespace
}  // namespace bimodal::runner

#include "runner/devices/sdl/sdl_keyboard.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <string_view>

#include <SDL2/SDL_events.h>
#include <SDL2/SDL_joystick.h>
#include <SDL2/SDL_mouse.h>
#include <gtest/gtest.h>

#include "runner/devices/device_error.hpp"

// clang-format off
#include <SDL2/SDL_syswm.h>  // last: no other header is safe from Xlib's macros

// clang-format on

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr InputStamp kStamp{.at = Instant{12s}, .uncertainty = 300us, .source = "poll"};
constexpr SdlWindow::Size kPoints{.width = 800, .height = 600};

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

TEST(KeystrokeOf, TakesTextAsUtf8WithItsStamp) {
  const auto keystroke = keystroke_of(text_input("é"), kStamp, kPoints);
  ASSERT_TRUE(keystroke);
  EXPECT_EQ(keystroke->key, Key::Text);
  EXPECT_EQ(keystroke->text, "é");
  EXPECT_EQ(keystroke->at, Instant{12s});
  EXPECT_EQ(keystroke->uncertainty, 300us);
  EXPECT_EQ(keystroke->source, "poll");
}

TEST(KeystrokeOf, KnowsTheEditingKeysAndBothEnterKeys) {
  EXPECT_EQ(keystroke_of(key_press(SDLK_RETURN), kStamp, kPoints)->key, Key::Enter);
  EXPECT_EQ(keystroke_of(key_press(SDLK_KP_ENTER), kStamp, kPoints)->key, Key::Enter);
  EXPECT_EQ(keystroke_of(key_press(SDLK_BACKSPACE), kStamp, kPoints)->key, Key::Backspace);
  EXPECT_EQ(keystroke_of(key_press(SDLK_LEFT), kStamp, kPoints)->key, Key::Left);
  EXPECT_EQ(keystroke_of(key_press(SDLK_ESCAPE), kStamp, kPoints)->key, Key::Escape);
}

TEST(KeystrokeOf, RepeatsBackspaceWhileHeldButNeitherEnterNorEscape) {
  EXPECT_TRUE(keystroke_of(key_press(SDLK_BACKSPACE, true), kStamp, kPoints));
  EXPECT_FALSE(keystroke_of(key_press(SDLK_RETURN, true), kStamp, kPoints));
  EXPECT_FALSE(keystroke_of(key_press(SDLK_KP_ENTER, true), kStamp, kPoints));
  EXPECT_FALSE(keystroke_of(key_press(SDLK_ESCAPE, true), kStamp, kPoints));
}

TEST(KeystrokeOf, TakesLettersOnlyFromTextInputSoThatNoneComesTwice) {
  EXPECT_FALSE(keystroke_of(key_press(SDLK_a), kStamp, kPoints));
  EXPECT_FALSE(keystroke_of(key_press(SDLK_LSHIFT), kStamp, kPoints));
}

TEST(KeystrokeOf, NoticesThatTheWindowIsClosed) {
  SDL_Event event{};
  event.type = SDL_QUIT;
  EXPECT_EQ(keystroke_of(event, kStamp, kPoints)->key, Key::WindowClosed);
  event.type = SDL_MOUSEMOTION;
  EXPECT_FALSE(keystroke_of(event, kStamp, kPoints));
}

TEST(KeystrokeOf, PlacesClicksInTheWindowAndNumbersButtonsFromOne) {
  SDL_Event click{};
  click.type = SDL_MOUSEBUTTONDOWN;
  click.button.button = SDL_BUTTON_RIGHT;
  click.button.x = 400;
  click.button.y = 150;
  const auto pointed = keystroke_of(click, kStamp, kPoints);
  ASSERT_TRUE(pointed);
  EXPECT_EQ(pointed->key, Key::Pointer);
  EXPECT_EQ(pointed->button, 3);
  EXPECT_NEAR(pointed->x, 0.5, 0.001);
  EXPECT_NEAR(pointed->y, 0.25, 0.001);
  SDL_Event button{};
  button.type = SDL_JOYBUTTONDOWN;
  button.jbutton.button = 0;
  const auto pressed = keystroke_of(button, kStamp, kPoints);
  ASSERT_TRUE(pressed);
  EXPECT_EQ(pressed->key, Key::Button);
  EXPECT_EQ(pressed->button, 1);
}

/// The rest needs a screen, be it Xvfb or a compositor without one.
class SdlKeyboardOnScreen : public testing::Test {
 protected:
  void SetUp() override {
    try {
      window_.emplace(SdlWindow::Options{.width = 320, .height = 240});
    } catch (const DeviceError& error) {
      GTEST_SKIP() << error.what();
    }
    keyboard_.emplace(*window_, clock_);
    static_cast<void>(keyboard_->poll());
  }

  static void push(SDL_Event event) { SDL_PushEvent(&event); }

  /// As SDL does under X11 before it makes an event of its own: the server's press of `keycode`.
  static void push_of_server(unsigned keycode, Instant at) {
    SDL_SysWMmsg message{};
    message.subsystem = SDL_SYSWM_X11;
    message.msg.x11.event.type = 2;  // KeyPress
    message.msg.x11.event.xkey.keycode = keycode;
    message.msg.x11.event.xkey.time = static_cast<unsigned long>(
        std::chrono::floor<std::chrono::milliseconds>(at.time_since_epoch()).count() & 0xffffffff);
    SDL_Event event{};
    event.type = SDL_SYSWMEVENT;
    event.syswm.msg = &message;
    push(event);
  }

  MonotonicClock clock_;
  std::optional<SdlWindow> window_;
  std::optional<SdlKeyboard> keyboard_;
};

TEST_F(SdlKeyboardOnScreen, StampsAKeyWhenItIsQueuedAndNotWhenItIsPolled) {
  window_->pump();
  const auto before = clock_.now();
  push(key_press(SDLK_RETURN));
  const auto after = clock_.now();
  window_->pump();
  const auto keystrokes = keyboard_->poll();
  ASSERT_EQ(keystrokes.size(), 1U);
  EXPECT_EQ(keystrokes[0].key, Key::Enter);
  EXPECT_EQ(keystrokes[0].source, "poll");
  EXPECT_GE(keystrokes[0].at, before);
  EXPECT_LE(keystrokes[0].at, after);
  EXPECT_LE(keystrokes[0].at - keystrokes[0].uncertainty, before);
}

TEST_F(SdlKeyboardOnScreen, GivesTextTheStampOfTheKeyThatBroughtIt) {
  push(key_press(SDLK_RETURN));
  push(text_input("x"));
  const auto keystrokes = keyboard_->poll();
  ASSERT_EQ(keystrokes.size(), 2U);
  EXPECT_EQ(keystrokes[1].text, "x");
  EXPECT_EQ(keystrokes[1].at, keystrokes[0].at);
  EXPECT_TRUE(keyboard_->poll().empty());
}

TEST_F(SdlKeyboardOnScreen, PrefersTheStampOfTheXServer) {
  if (SdlWindow::driver() != "x11") GTEST_SKIP() << "this is not X11";
  const auto pressed = clock_.now();
  push_of_server(36, pressed);
  push(key_press(SDLK_RETURN));
  push(text_input("x"));
  const auto keystrokes = keyboard_->poll();
  ASSERT_EQ(keystrokes.size(), 2U);
  for (const auto& keystroke : keystrokes) {
    EXPECT_EQ(keystroke.source, "server");
    EXPECT_GE(keystroke.at, pressed);
    EXPECT_LE(keystroke.at - keystroke.uncertainty, pressed);
    EXPECT_LE(keystroke.uncertainty, 2ms);
  }
}

TEST_F(SdlKeyboardOnScreen, DoesNotBelieveAServerWhoseTimeIsZero) {
  if (SdlWindow::driver() != "x11") GTEST_SKIP() << "this is not X11";
  push_of_server(36, Instant{});
  push(key_press(SDLK_RETURN));
  const auto keystrokes = keyboard_->poll();
  ASSERT_EQ(keystrokes.size(), 1U);
  EXPECT_EQ(keystrokes[0].source, "poll");
}

TEST_F(SdlKeyboardOnScreen, TakesClicksAtTheirPlaceInTheWindow) {
  const auto points = window_->points();
  SDL_Event click{};
  click.type = SDL_MOUSEBUTTONDOWN;
  click.button.button = SDL_BUTTON_LEFT;
  click.button.x = points.width / 4;
  click.button.y = points.height / 2;
  push(click);
  const auto keystrokes = keyboard_->poll();
  ASSERT_EQ(keystrokes.size(), 1U);
  EXPECT_EQ(keystrokes[0].key, Key::Pointer);
  EXPECT_EQ(keystrokes[0].button, 1);
  EXPECT_NEAR(keystrokes[0].x, 0.25, 0.01);
  EXPECT_NEAR(keystrokes[0].y, 0.5, 0.01);
}

TEST_F(SdlKeyboardOnScreen, OpensAButtonBoxThatIsPluggedInAndHearsItsButtons) {
  const int device = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, 0, 4, 0);
  if (device < 0) GTEST_SKIP() << "this SDL has no virtual joysticks";
  static_cast<void>(keyboard_->poll());
  auto* const box = SDL_JoystickFromInstanceID(SDL_JoystickGetDeviceInstanceID(device));
  ASSERT_NE(box, nullptr);
  SDL_JoystickSetVirtualButton(box, 2, SDL_PRESSED);
  const auto keystrokes = keyboard_->poll();
  ASSERT_EQ(keystrokes.size(), 1U);
  EXPECT_EQ(keystrokes[0].key, Key::Button);
  EXPECT_EQ(keystrokes[0].button, 3);
  EXPECT_EQ(keystrokes[0].source, "poll");
  SDL_JoystickDetachVirtual(device);
}

TEST_F(SdlKeyboardOnScreen, SurvivesMoreEventsThanItKeeps) {
  for (int k = 0; k < 1000; ++k) push(key_press(SDLK_RETURN));
  EXPECT_EQ(keyboard_->poll().size(), 256U);
  EXPECT_TRUE(keyboard_->poll().empty());
  push(key_press(SDLK_RETURN));
  EXPECT_EQ(keyboard_->poll().size(), 1U);
}

TEST_F(SdlKeyboardOnScreen, HidesThePointerUntilItIsAskedFor) {
  EXPECT_EQ(SDL_ShowCursor(SDL_QUERY), SDL_DISABLE);
  keyboard_->show_pointer(true);
  EXPECT_EQ(SDL_ShowCursor(SDL_QUERY), SDL_ENABLE);
  keyboard_->show_pointer(false);
  EXPECT_EQ(SDL_ShowCursor(SDL_QUERY), SDL_DISABLE);
}

TEST_F(SdlKeyboardOnScreen, SaysHowItsInstantsAreFound) {
  const auto description = keyboard_->description();
  EXPECT_NE(description.find("through SDL (" + SdlWindow::driver() + ")"), std::string::npos);
  EXPECT_NE(description.find("kernel"), std::string::npos) << description;
}

}  // namespace
}  // namespace bimodal::runner

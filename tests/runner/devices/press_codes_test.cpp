#include "runner/devices/sdl/press_codes.hpp"

#include <set>

#include <SDL2/SDL_events.h>
#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

namespace bimodal::runner {
namespace {

SDL_Event key_at(int scancode) {
  SDL_Event event{};
  event.type = SDL_KEYDOWN;
  event.key.keysym.scancode = static_cast<SDL_Scancode>(scancode);
  return event;
}

TEST(PressCode, NamesKeysByTheirPlaceWhateverTheyType) {
  auto event = key_at(SDL_SCANCODE_Q);
  event.key.keysym.sym = SDLK_a;  // as on a French keyboard
  EXPECT_EQ(press_code(event), static_cast<std::uint32_t>(KEY_Q));
  EXPECT_EQ(press_code(key_at(SDL_SCANCODE_RETURN)), static_cast<std::uint32_t>(KEY_ENTER));
  EXPECT_EQ(press_code(key_at(SDL_SCANCODE_NONUSBACKSLASH)), static_cast<std::uint32_t>(KEY_102ND));
}

TEST(PressCode, GivesEveryKeyItsOwnCode) {
  std::set<std::uint32_t> codes;
  int keys = 0;
  for (int scancode = 0; scancode < SDL_NUM_SCANCODES; ++scancode) {
    if (const auto code = press_code(key_at(scancode))) {
      codes.insert(*code);
      ++keys;
    }
  }
  EXPECT_EQ(keys, 105);
  EXPECT_EQ(codes.size(), 105U);
}

TEST(PressCode, NamesMouseButtons) {
  SDL_Event event{};
  event.type = SDL_MOUSEBUTTONDOWN;
  event.button.button = SDL_BUTTON_RIGHT;
  EXPECT_EQ(press_code(event), static_cast<std::uint32_t>(BTN_RIGHT));
  event.button.button = 17;
  EXPECT_FALSE(press_code(event));
}

TEST(PressCode, KnowsNoneForRepeatsAndOtherEvents) {
  auto repeated = key_at(SDL_SCANCODE_A);
  repeated.key.repeat = 1;
  EXPECT_FALSE(press_code(repeated));
  auto up = key_at(SDL_SCANCODE_A);
  up.type = SDL_KEYUP;
  EXPECT_FALSE(press_code(up));
}

}  // namespace
}  // namespace bimodal::runner

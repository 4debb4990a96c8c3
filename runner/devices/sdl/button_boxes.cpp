#include "runner/devices/sdl/button_boxes.hpp"

#include <SDL.h>

namespace bimodal::runner {

ButtonBoxes::ButtonBoxes() {
  SDL_SetHint(SDL_HINT_JOYSTICK_HIDAPI, "0");  // the kernel's drivers are enough
  SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
  started_ = SDL_InitSubSystem(SDL_INIT_JOYSTICK) == 0;
}

ButtonBoxes::~ButtonBoxes() {
  for (auto* const box : boxes_) SDL_JoystickClose(box);
  if (started_) SDL_QuitSubSystem(SDL_INIT_JOYSTICK);
}

void ButtonBoxes::open(int device) {
  if (auto* const box = SDL_JoystickOpen(device)) boxes_.push_back(box);
}

}  // namespace bimodal::runner

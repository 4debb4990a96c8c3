#pragma once

#include <vector>

struct _SDL_Joystick;

namespace bimodal::runner {

/// Opens the joysticks, game pads and button boxes (which call themselves so) of this machine, so
/// that SDL tells when their buttons go down. For SDL's thread, while there is a window.
class ButtonBoxes {
 public:
  ButtonBoxes();
  ButtonBoxes(const ButtonBoxes&) = delete;
  ButtonBoxes& operator=(const ButtonBoxes&) = delete;
  ButtonBoxes(ButtonBoxes&&) = delete;
  ButtonBoxes& operator=(ButtonBoxes&&) = delete;
  ~ButtonBoxes();

  /// The one that was plugged in, by SDL's number of the device (SDL_JOYDEVICEADDED).
  void open(int device);

 private:
  bool started_ = false;
  std::vector<_SDL_Joystick*> boxes_;
};

}  // namespace bimodal::runner

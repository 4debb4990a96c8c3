#pragma once

#include "runner/devices/audio_output.hpp"
#include "runner/devices/clock.hpp"
#include "runner/devices/display.hpp"
#include "runner/devices/keyboard.hpp"

namespace bimodal::runner {

/// The devices of one session, real or simulated. Borrowed.
struct Booth {
  Clock& clock;
  Display& display;
  Keyboard& keyboard;
  AudioOutput& audio;
};

}  // namespace bimodal::runner

#pragma once

#include <vector>

#include "runner/devices/audio_output.hpp"
#include "runner/devices/clock.hpp"
#include "runner/devices/display.hpp"
#include "runner/devices/keyboard.hpp"
#include "runner/devices/triggers/trigger_line.hpp"

namespace bimodal::runner {

/// The devices of one session, real or simulated. Borrowed.
struct Booth {
  Clock& clock;
  Display& display;
  Keyboard& keyboard;
  AudioOutput& audio;
  std::vector<TriggerLine*> trigger_lines{};  ///< to other equipment
};

}  // namespace bimodal::runner

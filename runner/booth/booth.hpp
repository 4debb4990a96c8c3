#pragma once

#include <vector>

#include "runner/devices/audio_output.hpp"
#include "runner/devices/clock.hpp"
#include "runner/devices/display.hpp"
#include "runner/devices/keyboard.hpp"
#include "runner/devices/triggers/trigger_line.hpp"

namespace bimodal::runner {

/// What onsets refer to. Picture and sound are timed so that both meet there.
struct OnsetReference {
  /// The line of the screen that counts is drawn so long after the instant that the display reports
  /// (that of the first line).
  Duration line_after{};
  /// Sound is heard so long after the instant that its device reports, compared with light after
  /// that of its display: the mean of a calibration by instruments.
  Duration sound_after{};
};

/// The devices of one session, real or simulated. Borrowed.
struct Booth {
  Clock& clock;
  Display& display;
  Keyboard& keyboard;
  AudioOutput& audio;
  std::vector<TriggerLine*> trigger_lines{};  ///< to other equipment
  OnsetReference reference{};
};

}  // namespace bimodal::runner

#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/devices/audio_input.hpp"
#include "runner/devices/clock.hpp"
#include "runner/devices/display.hpp"
#include "runner/devices/keyboard.hpp"
#include "runner/session/recording_machine.hpp"
#include "stimuli/corpus/take_folder.hpp"

namespace bimodal::runner {

/// A word to be recorded, and the take of it that counts.
struct WordSlot {
  std::string word;
  std::string file;  ///< in the folder of takes; empty: none
};

/// All that a recording session needs; borrowed.
struct RecordingParts {
  const Clock& clock;
  Display& display;
  Keyboard& keyboard;
  AudioInput& input;
  TakeFolder& folder;
  RecordingRules rules;
  bool simulated = false;             ///< stored with every take
  bool answers_itself = false;        ///< the keyboard is told what to press
  std::function<bool()> interrupted;  ///< asked at every refresh
  std::function<void(std::string_view)> announce;
};

struct RecordingOutcome {
  std::size_t done = 0;   ///< slots with a take that counts
  bool complete = false;  ///< all of them
};

/// Leads a talker through the words and stores every take before the next word is shown.
/// `slots` is not empty.
[[nodiscard]] RecordingOutcome record_words(const RecordingParts& parts,
                                            std::vector<WordSlot> slots);

}  // namespace bimodal::runner

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runner/devices/display.hpp"
#include "runner/session/recording_machine.hpp"
#include "stimuli/audio/take_check.hpp"

namespace bimodal::runner {

/// A take as the talker is told about it.
struct ShownTake {
  TakeMeasures measures;
  std::vector<TakeFault> faults;
};

/// What the talker sees: the word, what to do, a red dot while recording, what became of the last
/// take, how far the list is. `last` is absent before the first take.
[[nodiscard]] Screen recording_screen(const RecordingMachine& machine,
                                      const std::optional<ShownTake>& last);

}  // namespace bimodal::runner

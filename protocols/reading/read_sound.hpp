#pragma once

#include "protocols/model/protocol.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/base/object_reader.hpp"

namespace bimodal::protocols {

/// Reads the key "sound" of `parent`, and notes every mistake. What it leaves out stays.
void read_sound(ObjectReader& parent, Sound& sound, Findings& findings);

}  // namespace bimodal::protocols

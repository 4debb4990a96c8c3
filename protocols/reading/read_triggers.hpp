#pragma once

#include "protocols/model/triggers.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/base/object_reader.hpp"

namespace bimodal::protocols {

/// Reads the key "triggers" of `parent`, and notes every mistake. What it leaves out is not used.
[[nodiscard]] Triggers read_triggers(ObjectReader& parent, Findings& findings);

}  // namespace bimodal::protocols

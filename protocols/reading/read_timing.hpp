#pragma once

#include "protocols/model/timing.hpp"
#include "stimuli/base/object_reader.hpp"

namespace bimodal::protocols {

/// Reads the key "timing" of `parent`, and notes every mistake. What it leaves out has its default.
[[nodiscard]] Timing read_timing(ObjectReader& parent);

}  // namespace bimodal::protocols

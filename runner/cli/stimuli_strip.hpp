#pragma once

#include "runner/cli/verbs.hpp"

namespace bimodal::runner {

/// Adds `strip` to the sub-verbs of `stimuli`.
void add_stimuli_strip(CLI::App& stimuli, Verb& chosen);

}  // namespace bimodal::runner

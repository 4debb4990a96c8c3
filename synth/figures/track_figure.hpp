#pragma once

#include <string>

#include "stimuli/figures/figure.hpp"
#include "synth/speech/tracks.hpp"

namespace bimodal::synth {

/// A panel for each control of the tracks, segments named at the top, targets as circles; with
/// dominances above it, where the tracks have them. Controls that do not move are left out, unless
/// none does.
[[nodiscard]] Figure figure_of(const Tracks& tracks, const std::string& title);

}  // namespace bimodal::synth

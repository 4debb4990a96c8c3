#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "synth/render/appearance.hpp"

namespace bimodal::runner {

/// Where a face shines that is nothing but points of light, by name; "none": it is a whole face.
inline constexpr std::array<std::pair<std::string_view, synth::Points>, 4> kPointNames{
    {{"none", synth::Points::None},
     {"sparse", synth::Points::Sparse},
     {"lips", synth::Points::Lips},
     {"all", synth::Points::All}}};

}  // namespace bimodal::runner

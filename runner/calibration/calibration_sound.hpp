#pragma once

#include <variant>

#include "stimuli/audio/band.hpp"
#include "stimuli/audio/clip.hpp"

namespace bimodal::runner {

/// What is played while a level is measured.
struct CalibrationSound {
  std::variant<Band, Hertz> content = Band{};  ///< noise of a band, as the mixer's; or a tone
  Decibels level{-30};                         ///< RMS, dB re full scale
  Hertz rate{48'000};
  Duration length = std::chrono::seconds{60};
};

/// Its samples, with ramps of 50 ms at both ends. Throws Error if it would clip, or its band or
/// frequency does not fit the rate.
[[nodiscard]] Clip made(const CalibrationSound& sound);

}  // namespace bimodal::runner

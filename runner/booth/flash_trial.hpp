#pragma once

#include "runner/preparation/trial_preparer.hpp"

namespace bimodal::runner {

/// A flash and a beep that begin together, for measuring how the presenter times them.
struct FlashTrial {
  Hertz drawing_rate{60};
  Hertz sound_rate{48'000};
  int size = 480;                                   ///< of the picture in pixels, even
  Duration lead = std::chrono::milliseconds{200};   ///< dark picture before the flash
  Duration flash = std::chrono::milliseconds{100};  ///< how long it is white
  Duration trail = std::chrono::milliseconds{150};  ///< dark picture after it
  Duration beep = std::chrono::milliseconds{50};    ///< 1 kHz, from its first sample at full level
  double level = 0.25;                              ///< its amplitude, full scale 1
  Duration av_offset{};                             ///< audio minus visual
};

/// The left half of the picture is black, and white during the flash: the place for a photodiode.
/// The right half tells frames apart: it steps through four grey levels, frame by frame. Film and
/// sound take the way that those of every trial take.
[[nodiscard]] PreparedTrial make_flash_trial(const FlashTrial& flash);

/// The grey level of the right half in frame `frame`: 0, 85, 170 or 255.
[[nodiscard]] int frame_level(std::int64_t frame);

}  // namespace bimodal::runner

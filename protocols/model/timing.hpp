#pragma once

#include "stimuli/base/quantity.hpp"

namespace bimodal::protocols {

/// Which line of the screen visual onsets refer to: a screen is drawn downwards, within most of a
/// refresh.
enum class VisualLine {
  First,
  Mouth,  ///< at the height of the mouth in the picture
};

/// What becomes of a trial whose timing was not as planned.
enum class Flagged {
  Keep,     ///< it is flagged, no more
  Exclude,  ///< it is not to be analysed
  Repeat,   ///< it is not to be analysed, and is presented again at the end of its block
};

struct Timing {
  VisualLine visual_line = VisualLine::First;
  Flagged flagged = Flagged::Keep;
  int most_repeats = 3;  ///< of one trial
  /// The reported audio-visual offset may differ so much from the intended one.
  Duration offset_tolerance = std::chrono::milliseconds{4};

  bool operator==(const Timing&) const = default;
};

}  // namespace bimodal::protocols

#pragma once

#include <cstddef>

#include "stimuli/picture/drawing.hpp"

namespace bimodal::synth {

/// What stands behind the head: the two colours of a soft round glow; equal for a plain ground.
struct Backdrop {
  Colour centre{96, 108, 122};
  Colour edge{52, 58, 68};
};

/// From where and how the head is seen.
struct View {
  std::size_t width = 640;     ///< pixels
  std::size_t height = 720;    ///< pixels
  double yaw_deg = 0.0;        ///< camera round the head; positive shows the subject's left side
  double pitch_deg = 0.0;      ///< positive looks from above
  double centre_y_mm = -30.0;  ///< what stands in the middle of the picture
  double field_mm = 270.0;     ///< height of the picture at the head's centre
  Backdrop backdrop;
};

}  // namespace bimodal::synth

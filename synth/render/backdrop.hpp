#pragma once

#include "stimuli/picture/drawing.hpp"

namespace bimodal::synth {

/// What stands behind the head: the two colours of a soft round glow; equal for a plain ground.
struct Backdrop {
  Colour centre{96, 108, 122};
  Colour edge{52, 58, 68};

  bool operator==(const Backdrop&) const = default;
};

}  // namespace bimodal::synth

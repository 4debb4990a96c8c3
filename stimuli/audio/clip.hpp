#pragma once

#include <vector>

#include "stimuli/base/quantity.hpp"

namespace bimodal {

/// Sound of one channel. Samples are in full-scale units: a value beyond [-1, 1] clips.
struct Clip {
  Hertz rate{48'000};
  std::vector<float> samples;

  [[nodiscard]] Duration duration() const {
    return std::chrono::duration_cast<Duration>(
        std::chrono::duration<double>{static_cast<double>(samples.size()) / rate.count()});
  }
};

}  // namespace bimodal

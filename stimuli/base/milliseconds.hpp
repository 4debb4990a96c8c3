#pragma once

#include <chrono>

#include "stimuli/base/quantity.hpp"

namespace bimodal {

/// A duration as a number of milliseconds, for text and tables.
[[nodiscard]] constexpr double milliseconds(Duration duration) {
  return Milliseconds{duration}.count();
}

}  // namespace bimodal

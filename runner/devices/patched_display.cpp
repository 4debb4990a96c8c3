#include "runner/devices/patched_display.hpp"

#include <algorithm>
#include <utility>

namespace bimodal::runner {

namespace {

constexpr std::size_t kRoomForMarks = 16;

}  // namespace

PatchedDisplay::PatchedDisplay(Display& display, Patch patch)
    : display_{display}, patch_{std::move(patch)} {
  shown_.marks.reserve(kRoomForMarks);
}

Presentation PatchedDisplay::present(const Screen& screen, Instant deadline) {
  const bool lit = screen.at_zero || still_lit(deadline);
  shown_ = screen;  // vectors keep their room
  shown_.marks.push_back(lit ? patch_.at_zero : patch_.at_rest);
  const auto presentation = display_.present(shown_, deadline);
  last_ = presentation.onset;
  if (screen.at_zero) {
    zero_ = presentation.onset;
  } else if (!lit) {
    zero_.reset();
  }
  return presentation;
}

/// Whether the refresh to come is nearer to the patch's beginning than to its end, or between.
bool PatchedDisplay::still_lit(Instant deadline) const {
  if (!zero_) return false;
  const auto period = display_.refresh().period;
  const auto expected = std::max(deadline, last_ + period);
  return expected + period / 2 < *zero_ + patch_.length;
}

std::string PatchedDisplay::description() const {
  return display_.description() + "; with a patch for a photodiode, " + patch_.described;
}

}  // namespace bimodal::runner

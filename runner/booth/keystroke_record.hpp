#pragma once

#include "runner/session/keystroke.hpp"
#include "runner/store/records.hpp"

namespace bimodal::runner {

/// The keystroke as it is stored.
[[nodiscard]] inline KeystrokeRecord record_of(const Keystroke& stroke) {
  KeystrokeRecord record{.at = stroke.at.time_since_epoch(),
                         .source = std::string{stroke.source},
                         .key = label(stroke),
                         .uncertainty = stroke.uncertainty};
  if (stroke.key == Key::Pointer) {
    record.x = stroke.x;
    record.y = stroke.y;
  }
  return record;
}

}  // namespace bimodal::runner

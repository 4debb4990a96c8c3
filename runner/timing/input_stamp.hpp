#pragma once

#include <string_view>

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// When something was pressed: word of it reached the source of the stamp within [at - uncertainty,
/// at]. What comes before is not known here: the keyboard's own scanning and sending, some 1 to 20
/// ms, and for "poll" the way through the window system.
struct InputStamp {
  Instant at;
  Duration uncertainty{};
  std::string_view source;  ///< "evdev" and "compositor": the kernel; "server": the X server;
                            ///< "poll": this program
};

/// The stamp of something pressed at `counted` or up to one `grain` later, because that clock
/// counts whole grains and rounds down; but not later than it was noticed.
[[nodiscard]] inline InputStamp stamp_of_count(Instant counted,
                                               Duration grain,
                                               Instant noticed,
                                               std::string_view source) {
  const auto latest = counted + grain < noticed ? counted + grain : noticed;
  return {.at = latest, .uncertainty = latest - counted, .source = source};
}

}  // namespace bimodal::runner

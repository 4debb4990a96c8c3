#pragma once

#include <vector>

#include "stimuli/video/libav.hpp"

namespace bimodal::libav {

/// When the frames of a picture track are seen, on the file's clock, as far as its packets were
/// looked through.
struct FrameTimes {
  AVRational rate{.num = 0, .den = 1};  ///< frames a second; 0/1 if unknown
  bool regular = false;                 ///< frame i begins at the first one's time + i / rate
  bool complete = false;                ///< every packet names its time, no two the same
  std::vector<Duration> starts;         ///< in order; of those looked through
};

/// From the times of the packets, in any order. `first` is when the first frame that can be decoded
/// begins: what is predicted from frames before the beginning of the file is never seen.
[[nodiscard]] FrameTimes frame_times(const AVStream& track,
                                     std::vector<Duration> starts,
                                     Duration first,
                                     bool complete);

}  // namespace bimodal::libav

#include "stimuli/video/frame_times.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bimodal::libav {

namespace {

bool is_known(AVRational rate) {
  return rate.num > 0 && rate.den > 0;
}

/// Whether the starts lie on the grid of `rate` from the first on, each on the next place, but for
/// the rounding to their `unit`.
bool follow(const std::vector<Duration>& starts, AVRational rate, AVRational unit) {
  if (!is_known(rate)) return false;
  constexpr double kNanoseconds = 1e9;
  constexpr double kOwnRounding = 1000.0;
  const double period = kNanoseconds / av_q2d(rate);
  const double rounding = std::min(1.01 * av_q2d(unit) * kNanoseconds, period / 4);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const auto expected = static_cast<double>(i) * period;
    const auto found = static_cast<double>((starts[i] - starts.front()).count());
    if (std::abs(found - expected) > std::max(rounding, kOwnRounding)) return false;
  }
  return true;
}

}  // namespace

FrameTimes frame_times(const AVStream& track,
                       std::vector<Duration> starts,
                       Duration first,
                       bool complete) {
  FrameTimes times{.rate = track.avg_frame_rate, .complete = complete};
  std::ranges::sort(starts);
  if (std::ranges::adjacent_find(starts) != starts.end()) times.complete = false;
  starts.erase(starts.begin(), std::ranges::lower_bound(starts, first));
  for (const auto rate : {track.avg_frame_rate, track.r_frame_rate}) {
    if (!follow(starts, rate, track.time_base)) continue;
    times.rate = rate;
    times.regular = true;
    break;
  }
  if (!is_known(times.rate)) times.rate = track.r_frame_rate;
  times.starts = std::move(starts);
  return times;
}

}  // namespace bimodal::libav

#include "runner/timing/stream_times.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace bimodal::runner {

TimeSourceVerdict judge_stream_times(std::span<const CallbackTimes> readings, Hertz nominal_rate) {
  constexpr std::size_t kFewest = 16;
  constexpr double kShortest = 0.02;          // s
  constexpr double kFarthest = 2.0;           // s between now and the output
  constexpr double kLargestRateError = 0.02;  // of the rate
  constexpr double kJitter = 0.005;           // s
  if (readings.size() < kFewest) return {false, "too few readings"};
  const auto& first = readings.front();
  const auto& last = readings.back();
  const double played = static_cast<double>(last.sample - first.sample) / nominal_rate.count();
  if (played < kShortest) return {false, "too few readings"};

  const auto all = [&](auto condition) { return std::ranges::all_of(readings, condition); };
  if (!all([](const auto& r) { return std::isfinite(r.current) && std::isfinite(r.output); })) {
    return {false, "the host gives no numbers"};
  }
  if (all([](const auto& r) { return r.output == 0.0; })) return {false, "the host gives zero"};
  if (all([&](const auto& r) { return r.output == first.output; })) {
    return {false, "the host gives a constant"};
  }
  if (!all([](const auto& r) {
        return r.output >= r.current && r.output - r.current <= kFarthest;
      })) {
    return {false, "now and output do not share an origin"};
  }
  const std::chrono::duration<double> elapsed{last.entry - first.entry};
  const auto proceeds = [&](double by) {
    return std::abs(by - elapsed.count()) <= kLargestRateError * elapsed.count() + kJitter;
  };
  if (!proceeds(last.output - first.output) || !proceeds(last.current - first.current)) {
    return {false, "stream time does not proceed with the session clock"};
  }
  return {true, {}};
}

ClockPair output_reading(const CallbackTimes& times,
                         bool stream_times_plausible,
                         Duration latency) {
  if (!stream_times_plausible) return {times.sample, times.entry + latency};
  constexpr double kNanosecondsPerSecond = 1e9;
  const double ahead = (times.output - times.current) * kNanosecondsPerSecond;
  return {times.sample, times.entry + Duration{std::llround(ahead)}};
}

CallbackTimes mirrored(const CallbackTimes& times) {
  auto ahead = times;
  ahead.output = times.current + (times.current - times.output);
  return ahead;
}

ClockPair input_reading(const CallbackTimes& times, bool stream_times_plausible, Duration latency) {
  const auto ahead = output_reading(mirrored(times), stream_times_plausible, latency);
  return {times.sample, times.entry - (ahead.instant - times.entry)};
}

}  // namespace bimodal::runner

#pragma once

#include <cstdint>
#include <span>

#include "runner/timing/clock_map.hpp"
#include "runner/timing/time_source_verdict.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// What an audio callback was told and saw. Stream times are in seconds from an origin that differs
/// between hosts (JACK's is CLOCK_MONOTONIC_RAW); some hosts give 0 or a constant.
struct CallbackTimes {
  std::int64_t sample = 0;  ///< stream sample of the buffer's first frame
  Instant entry;            ///< session clock when the callback began
  double current = 0.0;     ///< the host's "now" when it called
  double output = 0.0;      ///< when the buffer's first sample will be at the output
};

/// Whether the host's stream times can be believed: finite, not zero, not constant, the output 0 to
/// 2 s ahead of the host's now, and both proceeding with the session clock to 2 % (and 5 ms).
/// Needs at least 16 readings spanning 20 ms of samples.
[[nodiscard]] TimeSourceVerdict judge_stream_times(std::span<const CallbackTimes> readings,
                                                   Hertz nominal_rate);

/// When the first sample of that buffer is at the output. With plausible stream times it is
/// entry + (output - current), in which the origin cancels; else entry + latency.
[[nodiscard]] ClockPair output_reading(const CallbackTimes& times,
                                       bool stream_times_plausible,
                                       Duration latency);

/// The same of a stream of input, whose callback is told in `output` when the buffer's first sample
/// was captured, before the host's now: its times as those of an output that is as far ahead.
[[nodiscard]] CallbackTimes mirrored(const CallbackTimes& times);

/// When the first sample of an input's buffer was captured; `times` as the callback was told.
[[nodiscard]] ClockPair input_reading(const CallbackTimes& times,
                                      bool stream_times_plausible,
                                      Duration latency);

}  // namespace bimodal::runner

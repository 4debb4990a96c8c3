#include "runner/timing/start_up_gate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "stimuli/base/milliseconds.hpp"

namespace bimodal::runner {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kFewestFlips = 100;
constexpr Duration kLargestDeviation = 2ms;
constexpr Duration kGoodDeviation = 100us;

bool is_outlier(Duration interval, Duration period) {
  return 5 * std::chrono::abs(interval - period) > period;
}

void measure(const StartUp& start_up, Gate& gate) {
  gate.flips = start_up.intervals.size();
  if (start_up.intervals.empty()) return;
  auto sorted = start_up.intervals;
  std::ranges::sort(sorted);
  gate.period = sorted[sorted.size() / 2];
  gate.longest = sorted.back();
  double count = 0.0;
  double mean = 0.0;
  double squares = 0.0;
  for (const auto interval : sorted) {
    if (is_outlier(interval, gate.period)) {
      ++gate.outliers;
      continue;
    }
    count += 1.0;
    const double from_mean = static_cast<double>(interval.count()) - mean;
    mean += from_mean / count;
    squares += from_mean * (static_cast<double>(interval.count()) - mean);
  }
  if (count >= 2.0) gate.deviation = Duration{std::llround(std::sqrt(squares / (count - 1.0)))};
}

/// Why the screen cannot time anything.
std::vector<std::string> obstacles(const StartUp& start_up, const Gate& gate) {
  std::vector<std::string> found;
  if (!start_up.is_seen) {
    found.emplace_back("nobody sees when pictures appear: instants are predicted");
    return found;
  }
  if (gate.flips < kFewestFlips) {
    found.push_back(
        fmt::format("only {} flips were measured, {} are needed", gate.flips, kFewestFlips));
  }
  if (gate.deviation > kLargestDeviation) {
    found.push_back(fmt::format("periods vary by {:.2f} ms (SD), more than {:g}",
                                milliseconds(gate.deviation),
                                milliseconds(kLargestDeviation)));
  }
  if (20 * gate.outliers > gate.flips) {
    found.push_back(
        fmt::format("{} of {} periods are more than 20 % off", gate.outliers, gate.flips));
  }
  const auto off = std::chrono::abs(gate.period - start_up.nominal);
  if (start_up.nominal > Duration::zero() && 5 * off > start_up.nominal) {
    found.push_back(fmt::format("the period is {:.2f} ms, that of the display mode {:.2f}",
                                milliseconds(gate.period),
                                milliseconds(start_up.nominal)));
  }
  return found;
}

/// Why it is not good.
std::vector<std::string> doubts(const StartUp& start_up, const Gate& gate) {
  std::vector<std::string> found;
  if (start_up.is_composited && !start_up.by_hardware) {
    found.emplace_back(
        "a compositor shows the window, and its word on when is not that of the display hardware");
  }
  if (gate.deviation > kGoodDeviation) {
    found.push_back(fmt::format("periods vary by {:.3f} ms (SD), more than {:g}",
                                milliseconds(gate.deviation),
                                milliseconds(kGoodDeviation)));
  }
  if (100 * gate.outliers > gate.flips) {
    found.push_back(
        fmt::format("{} of {} periods are more than 20 % off", gate.outliers, gate.flips));
  }
  return found;
}

}  // namespace

std::string_view name(TimingVerdict verdict) {
  switch (verdict) {
    case TimingVerdict::Good:
      return "good";
    case TimingVerdict::Usable:
      return "usable";
    case TimingVerdict::NotForTiming:
      return "not_for_timing";
  }
  return "unknown";
}

Gate judge(const StartUp& start_up) {
  Gate gate;
  measure(start_up, gate);
  gate.reasons = obstacles(start_up, gate);
  if (!gate.reasons.empty()) return gate;
  gate.reasons = doubts(start_up, gate);
  gate.verdict = gate.reasons.empty() ? TimingVerdict::Good : TimingVerdict::Usable;
  return gate;
}

}  // namespace bimodal::runner

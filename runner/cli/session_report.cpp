#include "runner/cli/session_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stimuli/base/milliseconds.hpp"

namespace bimodal::runner {

namespace {

/// By nearest rank.
double percentile_ms(const std::vector<Duration>& sorted, double part) {
  const auto rank = std::ceil(part * static_cast<double>(sorted.size()));
  return milliseconds(sorted.at(static_cast<std::size_t>(std::max(rank, 1.0)) - 1));
}

void report_storing(std::vector<Duration> delays) {
  if (delays.empty()) return;
  std::ranges::sort(delays);
  fmt::print(
      "answers were on the disk {:.2f} ms after the last stroke (median), {:.2f} ms at the 99th "
      "percentile, {:.2f} ms at most\n",
      percentile_ms(delays, 0.5),
      percentile_ms(delays, 0.99),
      milliseconds(delays.back()));
}

}  // namespace

void report_outcome(const SessionOutcome& outcome,
                    const SessionFrame& frame,
                    const std::optional<Resumption>& earlier) {
  const auto before = earlier ? earlier->done.size() : 0;
  fmt::print("{}: {} of {} trials stored in {}",
             outcome.complete ? "complete" : "stopped",
             before + static_cast<std::size_t>(outcome.trials),
             frame.planned,
             frame.data);
  if (before > 0) fmt::print(", {} of them before", before);
  if (outcome.repeated > 0) fmt::print("; {} repeated", outcome.repeated);
  const auto flagged = outcome.flagged + (earlier ? earlier->flagged : 0);
  if (flagged > 0) {
    fmt::print("; {} flagged, see table event\n", flagged);
  } else if (frame.predicted) {
    fmt::print(
        "; none flagged, but nobody reported when pictures were shown: onsets are predicted\n");
  } else {
    fmt::print("; timing as planned in all\n");
  }
  report_storing(outcome.storing);
  if (!outcome.complete) {
    fmt::print(
        "what was answered is kept; --resume goes on, --again begins this session anew, beside "
        "it\n");
  }
}

}  // namespace bimodal::runner

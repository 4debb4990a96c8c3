#include "runner/timing/presentation_report.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr Duration kFarthest = 1s;  ///< from an instant to the receipt of its report
constexpr double kRateError = 0.02;
constexpr Duration kJitter = 5ms;
constexpr double kPeriodError = 0.2;

double nanoseconds(Duration duration) {
  return static_cast<double>(duration.count());
}

}  // namespace

std::optional<std::uint64_t> refreshes_between(const PresentationReport& before,
                                               const PresentationReport& after) {
  if (!before.refresh || !after.refresh || *after.refresh < *before.refresh) return std::nullopt;
  return *after.refresh - *before.refresh;
}

TimeSourceVerdict judge_reports(std::span<const ReceivedReport> reports) {
  if (reports.size() < kFewestReports) return {false, "too few reports"};
  const auto is_far = [](const ReceivedReport& each) {
    return std::chrono::abs(each.received - each.report.shown) > kFarthest;
  };
  if (std::ranges::any_of(reports, is_far)) return {false, "it is not on the session clock"};
  const auto stands_still = [](const ReceivedReport& before, const ReceivedReport& after) {
    return after.report.shown <= before.report.shown;
  };
  if (std::ranges::adjacent_find(reports, stands_still) != reports.end()) {
    return {false, "its instants do not advance from picture to picture"};
  }
  const auto elapsed = reports.back().received - reports.front().received;
  const auto told = reports.back().report.shown - reports.front().report.shown;
  const auto allowed = kRateError * nanoseconds(elapsed) + nanoseconds(kJitter);
  if (std::abs(nanoseconds(told - elapsed)) > allowed) {
    return {false, "it does not proceed with the session clock"};
  }
  return {true, {}};
}

bool counts_refreshes(std::span<const ReceivedReport> reports, Duration period) {
  if (reports.size() < kFewestReports || period <= Duration::zero()) return false;
  const auto is_repeated = [](const ReceivedReport& before, const ReceivedReport& after) {
    const auto passed = refreshes_between(before.report, after.report);
    return !passed || *passed == 0;
  };
  if (std::ranges::adjacent_find(reports, is_repeated) != reports.end()) return false;
  const auto& first = reports.front().report;
  const auto& last = reports.back().report;
  const auto counted = static_cast<double>(refreshes_between(first, last).value_or(0));
  const auto per_count = nanoseconds(last.shown - first.shown) / counted;
  const auto per_picture = std::max(1.0, std::round(nanoseconds(period) / per_count));
  const auto expected = nanoseconds(period) / per_picture;
  return std::abs(per_count - expected) <= kPeriodError * expected;
}

std::optional<PresentationReport> report_of_swap(const SyncCounters& done, std::int64_t swap) {
  if (done.sbc != swap || done.ust <= 0) return std::nullopt;
  PresentationReport report{.shown = Instant{std::chrono::microseconds{done.ust}},
                            .refresh = std::nullopt};
  if (done.msc > 0) report.refresh = static_cast<std::uint64_t>(done.msc);
  return report;
}

}  // namespace bimodal::runner

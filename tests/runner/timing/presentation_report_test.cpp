#include "runner/timing/presentation_report.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr Duration kPeriod = 16'666'667ns;

/// Pictures at consecutive refreshes, each reported 200 us after it was shown.
std::vector<ReceivedReport> steady_reports(std::size_t count, std::uint64_t first_refresh = 5000) {
  std::vector<ReceivedReport> reports;
  for (std::size_t k = 0; k < count; ++k) {
    const auto shown = Instant{100s} + static_cast<std::int64_t>(k) * kPeriod;
    reports.push_back(
        {.report = {.shown = shown, .refresh = first_refresh + k}, .received = shown + 200us});
  }
  return reports;
}

TEST(JudgeReports, BelievesReportsThatFollowTheSessionClock) {
  EXPECT_TRUE(judge_reports(steady_reports(kFewestReports)).plausible);
  EXPECT_TRUE(judge_reports(steady_reports(100)).plausible);
}

TEST(JudgeReports, BelievesStampsALittleInTheFutureAsDriversGiveThem) {
  auto reports = steady_reports(100);
  for (auto& each : reports) each.received = each.report.shown - 2ms;
  EXPECT_TRUE(judge_reports(reports).plausible);
}

TEST(JudgeReports, WantsEnoughOfThem) {
  const auto verdict = judge_reports(steady_reports(kFewestReports - 1));
  EXPECT_FALSE(verdict.plausible);
  EXPECT_EQ(verdict.reason, "too few reports");
}

TEST(JudgeReports, RefusesInstantsOfTheWallClock) {
  auto reports = steady_reports(100);
  for (auto& each : reports) each.report.shown += 1'700'000'000s;
  EXPECT_EQ(judge_reports(reports).reason, "it is not on the session clock");
}

TEST(JudgeReports, RefusesEvenOneInstantMoreThanASecondOff) {
  auto reports = steady_reports(100);
  reports[50].received += 1001ms;
  EXPECT_FALSE(judge_reports(reports).plausible);
}

TEST(JudgeReports, RefusesInstantsThatStandStill) {
  auto reports = steady_reports(50);
  for (auto& each : reports) each.report.shown = reports.front().report.shown;
  EXPECT_EQ(judge_reports(reports).reason, "its instants do not advance from picture to picture");
}

TEST(JudgeReports, RefusesAClockOfAnotherPace) {
  auto reports = steady_reports(100);
  for (auto& each : reports) {
    each.report.shown += (each.report.shown - reports.front().received) / 10;
  }
  EXPECT_EQ(judge_reports(reports).reason, "it does not proceed with the session clock");
}

TEST(CountsRefreshes, KnowsACounterThatCountsEveryRefresh) {
  EXPECT_TRUE(counts_refreshes(steady_reports(100), kPeriod));
}

TEST(CountsRefreshes, AllowsMissedRefreshesAndPicturesAtEverySecondOne) {
  auto reports = steady_reports(100);
  for (std::size_t k = 40; k < reports.size(); ++k) {
    reports[k].report.shown += kPeriod;
    *reports[k].report.refresh += 1;
  }
  EXPECT_TRUE(counts_refreshes(reports, kPeriod));
  auto halved = steady_reports(100);
  for (std::size_t k = 0; k < halved.size(); ++k) *halved[k].report.refresh = 2 * k + 1;
  EXPECT_TRUE(counts_refreshes(halved, kPeriod));
}

TEST(CountsRefreshes, RefusesACounterThatStandsStillOrGoesBackOrIsNotThere) {
  auto still = steady_reports(100);
  for (auto& each : still) each.report.refresh = 7;
  EXPECT_FALSE(counts_refreshes(still, kPeriod));
  auto back = steady_reports(100);
  back[30].report.refresh = 1;
  EXPECT_FALSE(counts_refreshes(back, kPeriod));
  auto none = steady_reports(100);
  none[0].report.refresh.reset();
  EXPECT_FALSE(counts_refreshes(none, kPeriod));
}

TEST(CountsRefreshes, RefusesACounterThatLeavesOutRefreshes) {
  auto reports = steady_reports(100);
  for (std::size_t k = 0; k < reports.size(); ++k) {
    reports[k].report.shown = Instant{100s} + 2 * static_cast<std::int64_t>(k) * kPeriod;
  }
  EXPECT_FALSE(counts_refreshes(reports, kPeriod));
}

TEST(RefreshesBetween, IsTwoWhereOneWasMissed) {
  const PresentationReport before{.shown = Instant{1s}, .refresh = 10};
  EXPECT_EQ(refreshes_between(before, {.shown = Instant{2s}, .refresh = 11}), 1U);
  EXPECT_EQ(refreshes_between(before, {.shown = Instant{2s}, .refresh = 12}), 2U);
  EXPECT_FALSE(refreshes_between(before, {.shown = Instant{2s}, .refresh = 9}));
  EXPECT_FALSE(refreshes_between(before, {.shown = Instant{2s}, .refresh = std::nullopt}));
}

TEST(ReportOfSwap, TurnsMicrosecondsIntoAnInstantAndKeepsTheCount) {
  const auto report = report_of_swap({.ust = 1'234'567, .msc = 42, .sbc = 9}, 9);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->shown, Instant{1'234'567us});
  EXPECT_EQ(report->refresh, 42U);
}

TEST(ReportOfSwap, DiscardsTheCountersOfAnotherSwap) {
  EXPECT_FALSE(report_of_swap({.ust = 1'234'567, .msc = 42, .sbc = 8}, 9));
  EXPECT_FALSE(report_of_swap({.ust = 1'234'567, .msc = 42, .sbc = 10}, 9));
}

TEST(ReportOfSwap, TakesZeroForNoTimeAndNoCount) {
  EXPECT_FALSE(report_of_swap({.ust = 0, .msc = 42, .sbc = 9}, 9));
  const auto uncounted = report_of_swap({.ust = 5, .msc = 0, .sbc = 9}, 9);
  ASSERT_TRUE(uncounted);
  EXPECT_FALSE(uncounted->refresh);
}

}  // namespace
}  // namespace bimodal::runner

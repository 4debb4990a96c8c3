#include "runner/devices/x11/oml_reports.hpp"

#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "runner/devices/simulated/virtual_clock.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

/// A screen of 100 Hz whose driver is told when each swap is done, and what it says of it.
struct Driver {
  VirtualClock clock{Instant{50s}};
  std::int64_t done = 0;               ///< swaps
  std::optional<Instant> finishes;     ///< when the next swap will be done
  std::optional<SyncCounters> answer;  ///< of the wait; absent: an error
  bool answers = true;                 ///< about the counters
  int waits = 0;

  void advance_to(Instant instant) {
    clock.advance_to(instant);
    if (!finishes || clock.now() < *finishes) return;
    finishes.reset();
    ++done;
  }
};

class InjectedControl final : public SyncControl {
 public:
  explicit InjectedControl(Driver& driver) : driver_{driver} {}

  std::optional<SyncCounters> counters() override {
    if (!driver_.answers) return std::nullopt;
    return SyncCounters{.ust = 1, .msc = 1, .sbc = driver_.done};
  }

  std::optional<SyncCounters> await_swap(std::int64_t /*swap*/) override {
    ++driver_.waits;
    return driver_.answer;
  }

 private:
  Driver& driver_;
};

class OmlReportsTest : public testing::Test {
 protected:
  void SetUp() override { begin(); }

  /// As if `swaps` had been made before.
  void begin(std::int64_t swaps = 0) {
    driver_.done = swaps;
    reports_ = std::make_unique<OmlReports>(std::make_unique<InjectedControl>(driver_),
                                            driver_.clock,
                                            [this](Instant until) { driver_.advance_to(until); });
  }

  std::optional<PresentationReport> swap_done_after(Duration delay, const SyncCounters& answer) {
    reports_->request();
    driver_.finishes = driver_.clock.now() + delay;
    driver_.answer = answer;
    return reports_->await(100ms, [this] { ++pumps_; });
  }

  Driver driver_;
  std::unique_ptr<OmlReports> reports_;
  int pumps_ = 0;
};

TEST_F(OmlReportsTest, TellsWhenEachSwapWasShownAndAtWhichRefresh) {
  for (std::int64_t k = 1; k <= 20; ++k) {
    const auto report =
        swap_done_after(8ms, {.ust = 50'000'000 + 10'000 * k, .msc = 700 + k, .sbc = k});
    ASSERT_TRUE(report) << k;
    EXPECT_EQ(report->shown, Instant{50s} + k * 10ms);
    EXPECT_EQ(report->refresh, static_cast<std::uint64_t>(700 + k));
  }
  EXPECT_EQ(reports_->source(), TimeSource::DriverReported);
}

TEST_F(OmlReportsTest, CountsFromTheSwapsThatWereMadeBefore) {
  begin(1234);
  EXPECT_TRUE(swap_done_after(1ms, {.ust = 50'001'000, .msc = 1, .sbc = 1235}));
}

TEST_F(OmlReportsTest, LetsOthersWorkWhileItWaits) {
  ASSERT_TRUE(swap_done_after(8ms, {.ust = 50'008'000, .msc = 1, .sbc = 1}));
  EXPECT_GE(pumps_, 8);
  EXPECT_LE(driver_.clock.now(), Instant{50s + 9ms});
}

TEST_F(OmlReportsTest, GivesUpWhenThePatienceIsOverAndNeverAsksTheEndlessWait) {
  EXPECT_FALSE(swap_done_after(10s, {.ust = 60'000'000, .msc = 1, .sbc = 1}));
  EXPECT_EQ(driver_.clock.now(), Instant{50s + 100ms});
  EXPECT_EQ(driver_.waits, 0);
}

TEST_F(OmlReportsTest, AwaitsTheNextSwapAfterOneThatWasNotDoneInTime) {
  EXPECT_FALSE(swap_done_after(10s, {.ust = 60'000'000, .msc = 1, .sbc = 1}));
  driver_.done = 1;  // late, and nobody asks any more
  const auto next = swap_done_after(5ms, {.ust = 50'105'000, .msc = 9, .sbc = 2});
  ASSERT_TRUE(next);
  EXPECT_EQ(next->refresh, 9U);
}

TEST_F(OmlReportsTest, DiscardsTheAnswerAboutAnotherSwapAndCountsOnFromThere) {
  EXPECT_FALSE(swap_done_after(5ms, {.ust = 50'005'000, .msc = 3, .sbc = 4}));
  driver_.done = 4;
  EXPECT_TRUE(swap_done_after(5ms, {.ust = 50'015'000, .msc = 4, .sbc = 5}));
}

TEST_F(OmlReportsTest, SaysNothingWhereTheDriverFails) {
  reports_->request();
  driver_.finishes = Instant{50s + 1ms};
  driver_.answer.reset();
  EXPECT_FALSE(reports_->await(100ms, [] {}));
  driver_.answers = false;
  reports_->request();
  EXPECT_FALSE(reports_->await(100ms, [] {}));
}

}  // namespace
}  // namespace bimodal::runner

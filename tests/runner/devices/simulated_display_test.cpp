#include "runner/devices/simulated/simulated_display.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "runner/devices/headless/headless_display.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

TEST(VirtualClock, NeverGoesBack) {
  VirtualClock clock{Instant{5s}};
  clock.advance_to(Instant{4s});
  EXPECT_EQ(clock.now(), Instant{5s});
  clock.advance_to(Instant{6s});
  clock.advance_by(1ms);
  EXPECT_EQ(clock.now(), Instant{6001ms});
}

TEST(SimulatedDisplay, MeetsEveryDeadlineOnItsGridAndMovesTheClockThere) {
  VirtualClock clock;
  SimulatedDisplay display{clock, {.rate = Hertz{100}}};
  for (int k = 1; k <= 100; ++k) {
    const auto presentation = display.present({}, Instant{k * 10ms});
    EXPECT_EQ(presentation.onset, Instant{k * 10ms});
    EXPECT_EQ(presentation.lateness, 0ns);
    EXPECT_EQ(presentation.source, TimeSource::Predicted);
    EXPECT_EQ(clock.now(), presentation.onset);
  }
}

TEST(SimulatedDisplay, WaitsForADeadlineFarAheadAndTakesTheNextRefreshForOneInThePast) {
  VirtualClock clock;
  SimulatedDisplay display{clock, {.rate = Hertz{100}, .phase = Instant{3ms}}};
  EXPECT_EQ(display.present({}, Instant{10s}).onset, Instant{10s + 3ms});
  const auto late = display.present({}, Instant{1s});
  EXPECT_EQ(late.onset, Instant{10s + 13ms});
  EXPECT_EQ(late.lateness, 9s + 13ms);
}

TEST(SimulatedDisplay, IsLateByTheRefreshesThatItWasToldToDropAndThenOnTime) {
  VirtualClock clock;
  SimulatedDisplay display{clock, {.rate = Hertz{100}}};
  display.drop_next(2);
  const auto dropped = display.present({}, Instant{10ms});
  EXPECT_EQ(dropped.onset, Instant{30ms});
  EXPECT_EQ(dropped.lateness, 20ms);
  EXPECT_EQ(display.present({}, Instant{20ms}).onset, Instant{40ms});
  EXPECT_EQ(display.present({}, Instant{50ms}).lateness, 0ns);
}

TEST(SimulatedDisplay, LetsWhatWasShownBeObserved) {
  VirtualClock clock;
  SimulatedDisplay display{clock};
  std::vector<const Picture*> shown;
  std::vector<Instant> onsets;
  display.observe([&](const Screen& screen, const Presentation& presentation) {
    shown.push_back(screen.picture);
    onsets.push_back(presentation.onset);
  });
  const Picture picture;
  const Screen with_picture{.picture = &picture};
  const auto first = display.present(with_picture, Instant{}).onset;
  const auto second = display.present({}, Instant{}).onset;
  EXPECT_EQ(shown, (std::vector<const Picture*>{&picture, nullptr}));
  EXPECT_EQ(onsets, (std::vector<Instant>{first, second}));
}

TEST(SimulatedDisplay, SaysWhatItIs) {
  VirtualClock clock;
  const SimulatedDisplay display{clock};
  EXPECT_EQ(display.kind(), "simulated");
  EXPECT_NE(display.description().find("nothing is shown"), std::string::npos);
  EXPECT_EQ(display.refresh().period, 16'666'667ns);
  EXPECT_EQ(display.refresh().count, 0);
}

TEST(HeadlessDisplay, KeepsItsGridInRealTimeAndSaysThatNothingIsShown) {
  HeadlessDisplay display{{.rate = Hertz{1000}}};
  EXPECT_EQ(display.kind(), "headless");
  EXPECT_NE(display.description().find("nothing is shown"), std::string::npos);
  EXPECT_EQ(display.time_source(), TimeSource::Predicted);
  const auto grid = display.refresh();
  EXPECT_EQ(grid.period, 1ms);
  auto last = Instant{};
  for (int k = 0; k < 5; ++k) {
    const auto presentation = display.present({}, last);
    EXPECT_EQ((presentation.onset - grid.phase) % grid.period, 0ns);
    EXPECT_EQ(presentation.lateness, presentation.onset - last);
    EXPECT_EQ(presentation.source, TimeSource::Predicted);
    EXPECT_GE(MonotonicClock{}.now(), presentation.onset);
    EXPECT_GT(presentation.onset, last);
    last = presentation.onset;
  }
}

}  // namespace
}  // namespace bimodal::runner

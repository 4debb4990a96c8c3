// Screens that are no longer what they were when the session began.

#include <functional>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runner/booth/overseen_fixture.hpp"

namespace bimodal::runner {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class ScreenTrouble : public OverseenSession {};

/// Reports what it shows, except while it is asleep.
class SleepyDisplay final : public Display {
 public:
  SleepyDisplay(VirtualClock& clock) : display_{clock} {}

  Presentation present(const Screen& screen, Instant deadline) override {
    auto shown = display_.present(screen, deadline);
    shown.source = is_asleep ? TimeSource::Predicted : TimeSource::DriverReported;
    if (on_shown) on_shown(screen);
    return shown;
  }

  void wait(Instant until) override { display_.wait(until); }

  [[nodiscard]] RefreshEstimate refresh() const override {
    auto measured = display_.refresh();
    measured.period = period.value_or(measured.period);
    measured.count = 100;
    return measured;
  }

  [[nodiscard]] std::string kind() const override { return "sleepy"; }

  [[nodiscard]] std::string description() const override { return "sleepy"; }

  [[nodiscard]] TimeSource time_source() const override { return TimeSource::DriverReported; }

  bool is_asleep = false;
  std::optional<Duration> period;  ///< that it says it has
  std::function<void(const Screen&)> on_shown;

 private:
  SimulatedDisplay display_;
};

/// Presses Enter once, at the first poll after it was told to.
class PatientKeyboard final : public Keyboard {
 public:
  explicit PatientKeyboard(const Clock& clock) : typist_{clock}, clock_{clock} {}

  std::vector<Keystroke> poll() override {
    if (!presses_enter) return typist_.poll();
    presses_enter = false;
    return {{.key = Key::Enter, .at = clock_.now(), .source = "scripted"}};
  }

  void expect(std::string_view answer, Instant from) override {
    if (!answer.empty()) typist_.expect(answer, from);
  }

  [[nodiscard]] std::string description() const override { return "patient"; }

  bool presses_enter = false;

 private:
  SimulatedKeyboard typist_;
  const Clock& clock_;
};

TEST_F(ScreenTrouble, PausesWhenTheScreenFallsAsleepUntilSomebodyThereGoesOn) {
  trials_.add_faces();
  SleepyDisplay display{clock_};
  PatientKeyboard keyboard{clock_};
  std::size_t pages = 0;
  std::size_t stored = 0;
  display.on_shown = [&](const Screen& screen) {
    if (screen.captions.empty() || screen.captions[0].text == kPauseText) return;
    if (!screen.captions[0].text.starts_with("The experiment pauses")) return;
    stored = store_.trials.size();
    display.is_asleep = false;
    keyboard.presses_enter = ++pages == 50;
  };
  overseer_.on_progress = [&](const Progress& progress) {
    if (is(progress, 1, TrialState::Fixation)) display.is_asleep = true;
  };
  EXPECT_TRUE(run(&keyboard, &display).complete);
  EXPECT_EQ(pages, 50U);
  EXPECT_EQ(stored, 2U);
  ASSERT_THAT(store_.trials, SizeIs(kTrials));
  EXPECT_TRUE(store_.trials[1].flagged);
  EXPECT_FALSE(store_.trials[2].flagged);
  EXPECT_THAT(event_kinds(), ElementsAre("paused", "resumed"));
  EXPECT_THAT(store_.events.front().detail, HasSubstr("the screen reports nothing"));
}

TEST_F(ScreenTrouble, PausesWhenTheScreenHasAnotherRefreshThanBefore) {
  SleepyDisplay display{clock_};
  overseer_.on_progress = [&](const Progress& progress) {
    if (is(progress, 1, TrialState::Stored)) display.period = 13'333us;
  };
  EXPECT_TRUE(run(nullptr, &display).complete);  // the simulated participant goes on by itself
  EXPECT_THAT(store_.trials, SizeIs(kTrials));
  EXPECT_THAT(event_kinds(), ElementsAre("paused", "resumed"));
  EXPECT_THAT(store_.events.front().detail,
              HasSubstr("every 13.33 ms, not every 16.67 ms as before"));
}

TEST_F(ScreenTrouble, APauseOfTheExperimenterDoesNotEndByEnter) {
  PatientKeyboard keyboard{clock_};
  ask_at(0, TrialState::Stored, Request::Pause);
  overseer_.on_request = [&, asked = false]() mutable {
    if (pause_pages_.size() == 20) keyboard.presses_enter = true;
    if (asked || pause_pages_.size() < 60) return;
    overseer_.asked.push_back(Request::Resume);
    asked = true;
  };
  EXPECT_TRUE(run(&keyboard).complete);
  EXPECT_EQ(pause_pages_.size(), 60U);
}

}  // namespace
}  // namespace bimodal::runner

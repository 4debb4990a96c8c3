#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runner/booth/overseen_fixture.hpp"

namespace bimodal::runner {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using State = PauseChanged::State;

TEST_F(OverseenSession, TellsEveryStateOfEveryTrialAndItsResult) {
  EXPECT_TRUE(run().complete);
  ASSERT_THAT(overseer_.states, SizeIs(5 * kTrials));
  EXPECT_THAT(std::vector(overseer_.states.begin(), overseer_.states.begin() + 5),
              ElementsAre(TrialState::Preparing,
                          TrialState::Fixation,
                          TrialState::Presenting,
                          TrialState::Responding,
                          TrialState::Stored));
  EXPECT_THAT(overseer_.responses, ElementsAre("stew", "stew", "stew", "stew"));
  EXPECT_EQ(overseer_.outcome, "complete");
}

TEST_F(OverseenSession, TakesNoRequestWhileAStimulusIsOn) {
  overseer_.on_request = [this] { EXPECT_FALSE(trials_.is_held); };
  EXPECT_TRUE(run().complete);
}

TEST_F(OverseenSession, PausesAndGoesOnUntilAllTrialsAreStored) {
  ask_at(1, TrialState::Stored, Request::Pause);
  resume_after(100);
  EXPECT_TRUE(run().complete);
  EXPECT_THAT(store_.trials, SizeIs(kTrials));
  EXPECT_THAT(overseer_.pauses, ElementsAre(State::Asked, State::Paused, State::Running));
  EXPECT_THAT(event_kinds(), ElementsAre("paused", "resumed"));
  EXPECT_GT(store_.events[1].at - store_.events[0].at, 1s);
  ASSERT_THAT(pause_pages_, SizeIs(100));
  for (std::size_t i = 1; i < pause_pages_.size(); ++i) {
    EXPECT_LT(pause_pages_[i] - pause_pages_[i - 1], 3 * display_.refresh().period / 2);
  }
}

TEST_F(OverseenSession, PausesAfterTheAnswerThatHasBeenBegun) {
  ask_at(1, TrialState::Responding, Request::Pause);
  std::size_t stored = 0;
  display_.observe([&](const Screen& screen, const Presentation& shown) {
    if (screen.captions.empty() || screen.captions[0].text != kPauseText) return;
    stored = store_.trials.size();
    pause_pages_.push_back(shown.onset);
  });
  resume_after(10);
  EXPECT_TRUE(run().complete);
  EXPECT_EQ(stored, 2U);
  EXPECT_THAT(store_.trials, SizeIs(kTrials));
  EXPECT_EQ(store_.trials[1].response.text, "stew");
}

TEST_F(OverseenSession, TakesBackAPauseThatHasNotBegun) {
  overseer_.on_progress = [this](const Progress& progress) {
    if (!is(progress, 1, TrialState::Responding)) return;
    overseer_.asked = {Request::Pause, Request::Resume};
  };
  EXPECT_TRUE(run().complete);
  EXPECT_THAT(pause_pages_, IsEmpty());
  EXPECT_THAT(store_.events, IsEmpty());
  EXPECT_THAT(overseer_.pauses, ElementsAre(State::Asked, State::Running));
}

TEST_F(OverseenSession, PausesWhileATrialIsBeingPrepared) {
  trials_.waits = 50;
  ask_at(0, TrialState::Preparing, Request::Pause);
  resume_after(10);
  EXPECT_TRUE(run().complete);
  EXPECT_THAT(pause_pages_, SizeIs(10));
}

TEST_F(OverseenSession, PausesOnAPageAndComesBackToIt) {
  protocol_.instructions = {"Listen."};
  overseer_.on_progress = [this](const Progress& progress) {
    const bool first = std::holds_alternative<PageShown>(progress) && overseer_.pauses.empty();
    if (first) overseer_.asked.push_back(Request::Pause);
  };
  resume_after(10);
  EXPECT_TRUE(run().complete);
  EXPECT_THAT(pause_pages_, SizeIs(10));
  EXPECT_THAT(store_.events, IsEmpty());  // nothing is stored before the first trial
}

TEST_F(OverseenSession, StopsAfterAStimulusWithoutStoringTheTrial) {
  ask_at(2, TrialState::Presenting, Request::Stop);
  const auto outcome = run();
  EXPECT_FALSE(outcome.complete);
  EXPECT_EQ(outcome.trials, 2);
  EXPECT_THAT(store_.trials, SizeIs(2));
  EXPECT_THAT(event_kinds(), ElementsAre("stopped"));
  EXPECT_EQ(overseer_.outcome, "stopped");
  EXPECT_EQ(overseer_.states.back(), TrialState::Responding);
}

TEST_F(OverseenSession, StopsBetweenTrialsBeforeTheNextIsShown) {
  ask_at(1, TrialState::Stored, Request::Stop);
  EXPECT_EQ(run().trials, 2);
  EXPECT_THAT(store_.trials, SizeIs(2));
  EXPECT_EQ(overseer_.states.back(), TrialState::Stored);
}

TEST_F(OverseenSession, StopsDuringAPause) {
  overseer_.on_progress = [this](const Progress& progress) {
    if (is(progress, 1, TrialState::Responding)) overseer_.asked.push_back(Request::Pause);
    if (is_paused(progress)) overseer_.asked.push_back(Request::Stop);
  };
  EXPECT_EQ(run().trials, 2);
  EXPECT_THAT(store_.trials, SizeIs(2));
  EXPECT_THAT(event_kinds(), ElementsAre("paused", "stopped"));
}

/// Types without being asked, at every poll.
class RestlessKeyboard final : public Keyboard {
 public:
  explicit RestlessKeyboard(const Clock& clock) : clock_{clock} {}

  std::vector<Keystroke> poll() override {
    return {{.key = key, .text = "x", .at = clock_.now(), .source = "scripted"}};
  }

  void expect(std::string_view, Instant) override {}

  [[nodiscard]] std::string description() const override { return "restless"; }

  Key key = Key::Enter;

 private:
  const Clock& clock_;
};

TEST_F(OverseenSession, ThrowsKeysAwayDuringAPauseExceptEscape) {
  RestlessKeyboard keyboard{clock_};
  ask_at(0, TrialState::Stored, Request::Pause);
  overseer_.on_request = [&] {
    if (pause_pages_.size() == 20) keyboard.key = Key::Text;
    if (pause_pages_.size() == 40) keyboard.key = Key::Escape;  // asks, and confirms
  };
  EXPECT_EQ(run(&keyboard).trials, 1);
  EXPECT_GE(pause_pages_.size(), 40U);
  EXPECT_THAT(event_kinds(), ElementsAre("paused", "stopped"));
}

TEST_F(OverseenSession, IsNotHeldUpByRequestsWithoutEnd) {
  overseer_.on_request = [this] { overseer_.asked.push_back(Request::Resume); };
  EXPECT_TRUE(run().complete);
}

TEST_F(OverseenSession, TellsWhyItFailed) {
  store_.fails = true;
  EXPECT_THROW(static_cast<void>(run()), StoreError);
  EXPECT_EQ(overseer_.outcome, "failed");
  EXPECT_THAT(overseer_.detail, HasSubstr("the disk is full"));
}

}  // namespace
}  // namespace bimodal::runner

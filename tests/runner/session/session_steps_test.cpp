#include "runner/session/session_steps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

/// Steps as words: "#3" a trial, else a page's text.
std::vector<std::string> words(const std::vector<SessionStep>& steps) {
  std::vector<std::string> found;
  for (const auto& step : steps) {
    const auto* const trial = std::get_if<TrialStep>(&step);
    found.push_back(trial != nullptr ? "#" + std::to_string(trial->trial)
                                     : std::get<PageStep>(step).text);
  }
  return found;
}

std::vector<SessionStep> session() {
  return {PageStep{.text = "welcome"},
          TrialStep{.trial = 0},
          PageStep{.text = "main"},
          TrialStep{.trial = 1, .progress = 0.0},
          TrialStep{.trial = 2, .progress = 0.25},
          PageStep{.text = "break", .is_break = true},
          TrialStep{.trial = 3, .progress = 0.5},
          TrialStep{.trial = 4, .progress = 0.75},
          PageStep{.text = "thanks"}};
}

TEST(StepsLeft, AreAllWhereNothingIsDone) {
  EXPECT_EQ(words(steps_left(session(), {}, "on")), words(session()));
}

TEST(StepsLeft, BeginWithAGreetingAndTheFirstTrialThatIsNotDone) {
  const auto left = steps_left(session(), {0, 1}, "on");
  EXPECT_THAT(words(left), testing::ElementsAre("on", "#2", "break", "#3", "#4", "thanks"));
  EXPECT_EQ(std::get<PageStep>(left[0]).progress, 0.25);
}

TEST(StepsLeft, LeaveOutTheBreakBeforeTheFirstTrial) {
  EXPECT_THAT(words(steps_left(session(), {0, 1, 2}, "on")),
              testing::ElementsAre("on", "#3", "#4", "thanks"));
}

TEST(StepsLeft, KeepATrialThatIsMissingInTheMiddle) {
  EXPECT_THAT(words(steps_left(session(), {0, 1, 3}, "on")),
              testing::ElementsAre("on", "#2", "#4", "thanks"));
}

TEST(StepsLeft, OfASessionThatIsDoneAreItsLastWords) {
  EXPECT_THAT(words(steps_left(session(), {0, 1, 2, 3, 4}, "on")), testing::ElementsAre("thanks"));
}

}  // namespace
}  // namespace bimodal::runner

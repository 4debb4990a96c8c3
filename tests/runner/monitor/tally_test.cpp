#include "runner/monitor/tally.hpp"

#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

TEST(Tally, JudgesSpellingByLettersAlone) {
  EXPECT_TRUE(is_spelled_as("stew", " Stew "));
  EXPECT_FALSE(is_spelled_as("stew", "stu"));  // a homophone or not: the analysis judges that
  EXPECT_FALSE(is_spelled_as("stew", ""));
}

TEST(Tally, CountsMainTrialsByCondition) {
  Tally tally{{"A", "V"}};
  tally.add({.trial = 0, .is_practice = true, .condition = "A", .spelled_as_target = true});
  tally.add({.trial = 1, .condition = "V", .spelled_as_target = true});
  tally.add({.trial = 2, .condition = "V", .spelled_as_target = false, .flagged = true});
  tally.add({.trial = 3, .condition = "V"});  // dubbed: no one target
  EXPECT_EQ(tally.stored(), 4U);
  EXPECT_EQ(tally.flagged(), 1U);
  ASSERT_EQ(tally.conditions().size(), 2U);
  EXPECT_EQ(tally.conditions()[0].trials, 0U);
  EXPECT_EQ(tally.conditions()[1].condition, "V");
  EXPECT_EQ(tally.conditions()[1].trials, 3U);
  EXPECT_EQ(tally.conditions()[1].judged, 2U);
  EXPECT_EQ(tally.conditions()[1].spelled_as_target, 1U);
}

TEST(Tally, RemembersTheLastEightTrials) {
  Tally tally;
  for (std::size_t i = 0; i < 20; ++i) tally.add({.trial = i, .condition = "A"});
  ASSERT_EQ(tally.latest().size(), 8U);
  EXPECT_EQ(tally.latest().front().trial, 12U);
  EXPECT_EQ(tally.latest().back().trial, 19U);
}

}  // namespace
}  // namespace bimodal::runner

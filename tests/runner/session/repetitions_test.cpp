#include "runner/session/repetitions.hpp"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

using protocols::Flagged;
using protocols::PlannedTrial;
using ::testing::ElementsAre;

constexpr std::size_t kPlanned = 10;

Repetitions repetitions(int most = 3, Flagged rule = Flagged::Repeat) {
  return {{.flagged = rule, .most_repeats = most}, kPlanned};
}

PlannedTrial trial(std::size_t index) {
  PlannedTrial made;
  made.index = index;
  return made;
}

/// The originals of all repetitions, each of which is flagged again as `flagged` says.
std::vector<std::size_t> originals(Repetitions& repetitions, bool flagged) {
  std::vector<std::size_t> all;
  while (const auto repetition = repetitions.next()) {
    EXPECT_EQ(repetition->number, kPlanned + all.size());
    all.push_back(repetition->original);
    repetitions.finish();
    repetitions.note(trial(repetition->original), flagged);
  }
  return all;
}

TEST(Repetitions, AreOfFlaggedTrialsInTheirOrder) {
  auto block = repetitions();
  EXPECT_FALSE(block.note(trial(0), false));
  EXPECT_TRUE(block.note(trial(1), true));
  EXPECT_FALSE(block.note(trial(2), false));
  EXPECT_TRUE(block.note(trial(3), true));
  EXPECT_EQ(block.scheduled(), 2U);
  EXPECT_THAT(originals(block, false), ElementsAre(1, 3));
}

TEST(Repetitions, GoOnUntilTheTimingIsAsPlannedOrTheMostIsReached) {
  auto block = repetitions(2);
  block.note(trial(1), true);
  block.note(trial(3), true);
  EXPECT_THAT(originals(block, true), ElementsAre(1, 3, 1, 3));
}

TEST(Repetitions, AreNumberedOnFromBlockToBlock) {
  auto blocks = repetitions();
  blocks.note(trial(1), true);
  EXPECT_EQ(blocks.next()->number, 10U);
  blocks.finish();
  EXPECT_FALSE(blocks.next());
  blocks.note(trial(5), true);
  EXPECT_EQ(blocks.next()->number, 11U);
  EXPECT_EQ(blocks.scheduled(), 2U);
}

TEST(Repetitions, AreNeverOfPractice) {
  auto block = repetitions();
  auto practice = trial(0);
  practice.phase = protocols::Phase::Practice;
  EXPECT_FALSE(block.note(practice, true));
  EXPECT_FALSE(block.next());
}

TEST(Repetitions, AreMadeOnlyIfTheProtocolSaysSo) {
  for (const auto rule : {Flagged::Keep, Flagged::Exclude}) {
    auto block = repetitions(3, rule);
    EXPECT_FALSE(block.note(trial(0), true));
  }
}

}  // namespace
}  // namespace bimodal::runner

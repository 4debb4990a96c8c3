#include "runner/preparation/preparation_queue.hpp"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"

namespace bimodal::runner {
namespace {

std::vector<protocols::PlannedTrial> plan_of(std::size_t trials) {
  std::vector<protocols::PlannedTrial> plan(trials);
  for (std::size_t i = 0; i < trials; ++i) plan[i].index = i;
  return plan;
}

TEST(PreparationQueue, GivesEveryTrialInOrder) {
  PreparationQueue queue{plan_of(50), [] {
                           return [](const protocols::PlannedTrial& trial, const Checkpoint&) {
                             return PreparedTrial{.plan = trial};
                           };
                         }};
  for (std::size_t i = 0; i < 50; ++i) ASSERT_EQ(queue.next().plan.index, i);
}

TEST(PreparationQueue, HandsAFailureToTheSession) {
  PreparationQueue queue{plan_of(3), [] {
                           return [](const protocols::PlannedTrial& trial, const Checkpoint&) {
                             if (trial.index == 1) throw Error{"the sound of trial 2 would clip"};
                             return PreparedTrial{.plan = trial};
                           };
                         }};
  EXPECT_EQ(queue.next().plan.index, 0U);
  EXPECT_THROW(static_cast<void>(queue.next()), Error);
  EXPECT_TRUE(queue.ready());  // asking again does not wait for ever
}

TEST(PreparationQueue, KeepsNoMoreThanItMay) {
  std::atomic<int> prepared{0};
  PreparationQueue queue{plan_of(20),
                         [&] {
                           return [&](const protocols::PlannedTrial& trial, const Checkpoint&) {
                             ++prepared;
                             return PreparedTrial{.plan = trial};
                           };
                         },
                         2};
  for (int taken = 1; taken <= 20; ++taken) {
    static_cast<void>(queue.next());
    ASSERT_LE(prepared.load(), taken + 3);  // two kept, one in the making
  }
}

TEST(PreparationQueue, EndsWhileHeldAndUnfinished) {
  auto queue = std::make_unique<PreparationQueue>(plan_of(1'000), [] {
    return [](const protocols::PlannedTrial& trial, const Checkpoint& checkpoint) {
      checkpoint();
      return PreparedTrial{.plan = trial};
    };
  });
  queue->hold();
  queue.reset();
}

TEST(PreparationQueue, EndsInTheMiddleOfALongTrial) {
  std::atomic<bool> begun{false};
  auto queue = std::make_unique<PreparationQueue>(plan_of(1), [&begun] {
    return [&begun](const protocols::PlannedTrial&, const Checkpoint& checkpoint) -> PreparedTrial {
      for (;;) {
        begun = true;
        checkpoint();
      }
    };
  });
  while (!begun) std::this_thread::yield();
  queue.reset();
}

}  // namespace
}  // namespace bimodal::runner

#include "runner/store/store_writer.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "runner/store/store_error.hpp"

namespace bimodal::runner {
namespace {

/// Notes what it is asked for; its transactions wait for the test.
class NotedStore final : public SessionStore {
 public:
  std::int64_t begin(const SessionRecord& /*session*/,
                     std::span<const PlanRecord> /*plan*/) override {
    return 1;
  }

  void add(std::int64_t /*session*/, const TrialRecord& trial) override {
    began.set_value();
    goes_on.get_future().wait();
    deeds.push_back("trial " + std::to_string(trial.trial));
  }

  void add(std::int64_t /*session*/, const PlanRecord& /*planned*/) override {
    deeds.emplace_back("plan");
  }

  void add(std::int64_t /*session*/, const EventRecord& /*event*/) override {
    deeds.emplace_back("event");
    if (fails) throw StoreError{"the disk is full"};
  }

  void reopen(std::int64_t /*session*/) override {}

  void end(std::int64_t /*session*/, std::string_view /*how*/, std::string_view /*when*/) override {
  }

  void settle() override {
    deeds.emplace_back("settled");
    if (fails) throw StoreError{"the disk is full"};
  }

  bool fails = false;
  std::promise<void> began;
  std::promise<void> goes_on;
  std::vector<std::string> deeds;
};

TEST(StoreWriter, LetsTheStoreSettleOnlyWhenNothingIsLeftToDo) {
  NotedStore store;
  {
    StoreWriter writer{store};
    auto trial = writer.add(1, TrialRecord{.trial = 5});
    store.began.get_future().wait();
    auto plan = writer.add(1, PlanRecord{});
    auto event = writer.add(1, EventRecord{});
    store.goes_on.set_value();
    EXPECT_GE(trial.get(), Duration{});
    plan.get();
    event.get();
  }
  EXPECT_EQ(store.deeds, (std::vector<std::string>{"trial 5", "plan", "event", "settled"}));
}

TEST(StoreWriter, TellsOfATransactionThatFailedAndGoesOnAfterASettlingThatDid) {
  NotedStore store;
  store.fails = true;
  StoreWriter writer{store};
  EXPECT_THROW(writer.add(1, EventRecord{}).get(), StoreError);
  EXPECT_NO_THROW(writer.add(1, PlanRecord{}).get());
}

}  // namespace
}  // namespace bimodal::runner

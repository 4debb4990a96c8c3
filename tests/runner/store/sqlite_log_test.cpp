// When what was committed moves from the log beside the file into the file.
#include <atomic>
#include <thread>

#include "tests/runner/store/sqlite_fixture.hpp"

namespace bimodal::runner {
namespace {

using SqliteLogTest = SqliteStoreTest;

TEST_F(SqliteLogTest, ATrialIsNeverKeptWaitingByTheMovingOfOthersIntoTheFile) {
  constexpr int kTrials = 400;
  // SQLite's own moving, after 1000 pages, would use the log from its beginning again.
  constexpr std::uintmax_t kPages = 1'500;
  const auto store = open_sqlite_store(file_);
  const auto id = store->begin(session(), planned(kTrials));
  for (int i = 0; i < kTrials; ++i) store->add(id, trial(i));
  constexpr std::uintmax_t kPage = 4'096;
  EXPECT_GT(std::filesystem::file_size(log_), kPages * kPage);
}

TEST_F(SqliteLogTest, TheFileAloneIsABimodalFileFromTheBeginningOfASession) {
  const auto store = open_sqlite_store(file_);
  static_cast<void>(store->begin(session(), plan()));
  const auto alone = folder_ / "alone.sqlite";
  std::filesystem::copy_file(file_, alone);
  EXPECT_EQ(read_sessions(alone).front().planned_trials, 2);
}

TEST_F(SqliteLogTest, SettlesBesideTransactionsOfAnotherThread) {
  constexpr int kTrials = 60;
  const auto store = open_sqlite_store(file_);
  const auto id = store->begin(session(), planned(kTrials));
  std::atomic<bool> done = false;
  std::thread settling{[&] {
    while (!done) store->settle();
  }};
  for (int i = 0; i < kTrials; ++i) store->add(id, trial(i));
  done = true;
  settling.join();
  EXPECT_EQ(read_sessions(file_).front().trials.size(), std::size_t{kTrials});
}

TEST_F(SqliteLogTest, WhatIsSettledIsInTheFileItselfAndTheLogStaysShort) {
  constexpr int kTrials = 400;
  const auto store = open_sqlite_store(file_);
  const auto id = store->begin(session(), planned(kTrials));
  for (int i = 0; i < kTrials; ++i) {
    store->add(id, trial(i));
    store->settle();
  }
  EXPECT_LT(std::filesystem::file_size(log_), 1'000'000U);
  const auto alone = folder_ / "alone.sqlite";  // as somebody copies it who forgets the log
  std::filesystem::copy_file(file_, alone);
  constexpr std::size_t kAtMostInLog = 60;
  EXPECT_GT(read_sessions(alone).front().trials.size(), kTrials - kAtMostInLog);
  EXPECT_EQ(read_sessions(file_).front().trials.size(), std::size_t{kTrials});
}

}  // namespace
}  // namespace bimodal::runner

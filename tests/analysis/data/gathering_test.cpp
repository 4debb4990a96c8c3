#include "analysis/data/gathering.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/fault_of.hpp"

namespace bimodal::analysis {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Trial answered(std::string word,
               std::optional<Duration> first_key,
               std::optional<Duration> submitted) {
  Trial trial;
  trial.participant = "P1";
  trial.phase = "main";
  trial.condition = "visual";
  trial.word = std::move(word);
  trial.first_key = first_key;
  trial.submitted = submitted;
  return trial;
}

std::vector<TrialsOfFile> file_of(std::vector<Trial> trials) {
  SessionTrials session{.summary = {.participant = "P1", .outcome = "complete"},
                        .trials = std::move(trials)};
  std::vector<TrialsOfFile> files;
  files.push_back({.file = {"a.csv", "sha"}, .sessions = {std::move(session)}, .warnings = {"W"}});
  return files;
}

std::vector<std::string> words_of(const Dataset& dataset) {
  std::vector<std::string> words;
  for (const auto& trial : dataset.trials) words.push_back(trial.word);
  return words;
}

/// The first key counts, or where none is known the submission; the limits themselves are allowed.
TEST(Gathering, LeavesOutTooFastAndTooSlowAnswers) {
  const auto found = gather(file_of({answered("early", 199ms, 900ms),
                                     answered("just", 200ms, 9s),
                                     answered("before", -5ms, 900ms),
                                     answered("last", std::nullopt, 5000ms),
                                     answered("late", std::nullopt, 5001ms),
                                     answered("unknown", std::nullopt, std::nullopt)}),
                            {.fastest = 200ms, .slowest = 5s});
  EXPECT_THAT(words_of(found), ElementsAre("just", "last", "unknown"));
  EXPECT_THAT(found.exclusions,
              ElementsAre(Exclusion{"practice trial", 0},
                          Exclusion{"answered in less than 200 ms", 2},
                          Exclusion{"answered after more than 5000 ms", 1}));
  EXPECT_EQ(found.stored_trials, 6);
  EXPECT_EQ(found.sessions.front().analysed_trials, 3);
}

TEST(Gathering, CountsATrialUnderItsFirstReasonOnly) {
  auto bad = answered("bad", 1ms, 2ms);
  bad.phase = "practice";
  bad.excluded = true;
  bad.flagged = true;
  bad.simulated = true;
  auto flagged = bad;
  flagged.phase = "main";
  auto fast = flagged;
  fast.excluded = false;
  auto simulated = answered("simulated", 500ms, 600ms);
  simulated.simulated = true;
  const auto found =
      gather(file_of({bad, flagged, fast, simulated, answered("good", 500ms, 600ms)}),
             {.exclude_flagged = true, .exclude_simulated = true, .fastest = 200ms});
  EXPECT_THAT(words_of(found), ElementsAre("good"));
  std::int64_t left_out = 0;
  for (const auto& exclusion : found.exclusions) {
    EXPECT_LE(exclusion.trials, 1) << exclusion.reason;
    left_out += exclusion.trials;
  }
  EXPECT_EQ(left_out + std::ssize(found.trials), found.stored_trials);
  EXPECT_EQ(left_out, 4);
}

TEST(Gathering, WarnsOfTimingThatNobodyKnows) {
  auto unknown = answered("one", 1s, 2s);
  unknown.timing_known = false;
  const auto found = gather(file_of({unknown, answered("two", 1s, 2s)}), {.exclude_flagged = true});
  EXPECT_THAT(words_of(found), ElementsAre("one", "two"));
  EXPECT_THAT(found.warnings,
              testing::Contains(testing::HasSubstr("Of 1 trial it is not known whether")));
  EXPECT_THAT(gather(file_of({unknown})).warnings,
              testing::Not(testing::Contains(testing::HasSubstr("it is not known"))));
}

TEST(Gathering, KeepsFilesAndTheirWarnings) {
  auto files = file_of({answered("one", 1s, 2s)});
  auto more = file_of({answered("two", 1s, 2s)});
  more.front().file.name = "b.csv";
  more.front().sessions.front().summary.participant = "P2";
  more.front().sessions.front().trials.front().participant = "P2";
  files.push_back(std::move(more.front()));
  const auto found = gather(std::move(files));
  EXPECT_THAT(words_of(found), ElementsAre("one", "two"));
  EXPECT_EQ(found.files.at(1).name, "b.csv");
  EXPECT_EQ(found.trials[1].session, 1U);
  EXPECT_EQ(found.sessions.at(1).file, 1U);
  EXPECT_THAT(found.warnings, testing::Contains("W").Times(2));
}

/// By number, too: a word met again in a later trial is no copy.
TEST(Gathering, WarnsOfTrialsThatAreThereTwice) {
  const auto numbered = [](int number) {
    auto trial = answered("one", 1s, 2s);
    trial.trial = number;
    return trial;
  };
  EXPECT_THAT(gather(file_of({numbered(0), numbered(1)})).warnings,
              testing::Not(testing::Contains(HasSubstr("in the data already"))));
  const auto pasted = gather(file_of({numbered(0), numbered(1), numbered(1), numbered(1)}));
  EXPECT_THAT(pasted.warnings, testing::Contains(HasSubstr("2 trials are in the data already")));
  EXPECT_EQ(pasted.trials.size(), 4U);
  auto practised = numbered(1);
  practised.phase = "practice";
  EXPECT_THAT(gather(file_of({practised, numbered(1)}), {.include_practice = true}).warnings,
              testing::Not(testing::Contains(HasSubstr("in the data already"))));
  auto twice = file_of({numbered(7)});
  twice.push_back(twice.front());
  EXPECT_THAT(gather(std::move(twice)).warnings,
              testing::Contains(HasSubstr("1 trial is in the data already")));
}

TEST(Gathering, RefusesNamesThatDoNotOccur) {
  const auto fault = [](const Selection& selection) {
    return fault_of([&] { return gather(file_of({answered("one", 1s, 2s)}), selection); });
  };
  EXPECT_THAT(fault({.conditions = {"visul"}}),
              HasSubstr("no condition \"visul\" in the data; there is only visual"));
  EXPECT_THAT(fault({.participants = {"P2"}}), HasSubstr("no participant \"P2\""));
  EXPECT_THAT(fault({.conditions = {"visual"}, .participants = {"P1"}}), IsEmpty());
}

}  // namespace
}  // namespace bimodal::analysis

#include "protocols/design/plan.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"

namespace bimodal::protocols {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

WordList numbered_words(std::size_t count, const std::string& prefix = "w") {
  WordList list;
  for (std::size_t i = 0; i < count; ++i) {
    list.words.push_back({fmt::format("{}{}", prefix, i), {Phone::AA}});
  }
  return list;
}

Protocol protocol_with(std::size_t conditions, Assignment assignment = Assignment::Once) {
  Protocol protocol;
  protocol.title = "Test";
  protocol.seed = 1993;
  protocol.assignment = assignment;
  for (std::size_t i = 0; i < conditions; ++i) {
    Condition condition;
    condition.name = fmt::format("c{}", i);
    condition.auditory_talker = "festival:kal";
    protocol.conditions.push_back(condition);
  }
  return protocol;
}

std::vector<std::string> spellings(const std::vector<PlannedTrial>& plan) {
  std::vector<std::string> words;
  for (const auto& trial : plan) words.push_back(trial.word.spelling);
  return words;
}

std::multiset<std::string> sorted(const std::vector<PlannedTrial>& plan) {
  const auto words = spellings(plan);
  return {words.begin(), words.end()};
}

std::vector<std::size_t> trials_per_condition(const std::vector<PlannedTrial>& plan,
                                              std::size_t conditions) {
  std::vector<std::size_t> counts(conditions);
  for (const auto& trial : plan) ++counts.at(trial.condition);
  return counts;
}

TEST(PlanOnce, PresentsEveryWordExactlyOnce) {
  const auto words = numbered_words(50);
  for (int participant = 1; participant <= 20; ++participant) {
    const auto plan = make_plan(protocol_with(3), words, {}, {participant, 1});
    ASSERT_EQ(plan.size(), 50U);
    const auto presented = sorted(plan);
    for (const auto& word : words.words) EXPECT_EQ(presented.count(word.spelling), 1U);
  }
}

TEST(PlanOnce, LetsEveryWordMeetEveryConditionOnceOverAsManyParticipantsAsConditions) {
  for (const std::size_t conditions : {1U, 2U, 3U, 7U}) {
    std::map<std::string, std::multiset<std::size_t>> met;
    for (std::size_t p = 0; p < conditions; ++p) {
      const auto participant = static_cast<int>(p) + 5;  // any consecutive numbers will do
      const auto plan =
          make_plan(protocol_with(conditions), numbered_words(41), {}, {participant, 1});
      for (const auto& trial : plan) met[trial.word.spelling].insert(trial.condition);
    }
    ASSERT_EQ(met.size(), 41U);
    for (const auto& [word, where] : met) {
      for (std::size_t c = 0; c < conditions; ++c) EXPECT_EQ(where.count(c), 1U) << word;
    }
  }
}

TEST(PlanOnce, GivesConditionsListsThatDifferByAtMostOneWord) {
  for (const std::size_t words : {1U, 2U, 3U, 10U, 413U, 414U, 415U}) {
    const auto plan = make_plan(protocol_with(3), numbered_words(words), {}, {2, 1});
    const auto counts = trials_per_condition(plan, 3);
    const auto [fewest, most] = std::ranges::minmax(counts);
    EXPECT_LE(most - fewest, 1U) << words;
  }
  EXPECT_THAT(trials_per_condition(make_plan(protocol_with(3), numbered_words(414), {}, {1, 1}), 3),
              ElementsAre(138U, 138U, 138U));
}

TEST(PlanEveryCondition, LetsEveryWordMeetEveryConditionOnceOverTheSessionsOfOneParticipant) {
  const auto protocol = protocol_with(3, Assignment::EveryCondition);
  for (int participant = 1; participant <= 4; ++participant) {
    std::map<std::string, std::multiset<std::size_t>> met;
    for (int session = 1; session <= 3; ++session) {
      const auto plan = make_plan(protocol, numbered_words(20), {}, {participant, session});
      EXPECT_EQ(sorted(plan).size(), 20U);
      for (const auto& trial : plan) met[trial.word.spelling].insert(trial.condition);
    }
    for (const auto& [word, where] : met) {
      EXPECT_THAT(where, ElementsAre(0U, 1U, 2U)) << word;
    }
  }
}

TEST(PlanEveryCondition, BalancesTheFirstSessionOverParticipants) {
  const auto protocol = protocol_with(3, Assignment::EveryCondition);
  std::map<std::string, std::set<std::size_t>> met;
  for (int participant = 1; participant <= 3; ++participant) {
    for (const auto& trial : make_plan(protocol, numbered_words(20), {}, {participant, 1})) {
      met[trial.word.spelling].insert(trial.condition);
    }
  }
  for (const auto& [word, where] : met) EXPECT_EQ(where.size(), 3U) << word;
}

// The golden order was computed with a Python program of its own (SplitMix64, xoshiro256**,
// rejection sampling, Fisher and Yates, written from the published algorithms and from the comments
// of random.hpp and plan.hpp): tests/protocols/design/golden_plan.py.
TEST(Plan, IsTheSameOnEveryMachine) {
  const auto plan = make_plan(protocol_with(3), numbered_words(414), {}, {1, 1});
  const auto words = spellings(plan);
  const std::vector<std::string> first{words.begin(), words.begin() + 5};
  EXPECT_THAT(first, ElementsAre("w214", "w110", "w396", "w306", "w235"));
  std::vector<std::size_t> conditions;
  for (std::size_t i = 0; i < 5; ++i) conditions.push_back(plan[i].condition);
  EXPECT_THAT(conditions, ElementsAre(2U, 0U, 0U, 2U, 1U));
  EXPECT_EQ(plan.front().noise_seed, 0x4ecd42257ba7dd8cU);
}

TEST(Plan, DrawsAnOrderOfItsOwnForEveryParticipantAndSession) {
  const auto protocol = protocol_with(3, Assignment::EveryCondition);
  std::set<std::vector<std::string>> orders;
  for (int participant = 1; participant <= 30; ++participant) {
    for (int session = 1; session <= 3; ++session) {
      orders.insert(spellings(make_plan(protocol, numbered_words(20), {}, {participant, session})));
    }
  }
  EXPECT_EQ(orders.size(), 90U);
}

TEST(Plan, DependsOnTheSeed) {
  auto protocol = protocol_with(2);
  const auto one = make_plan(protocol, numbered_words(40), {}, {1, 1});
  protocol.seed += 1;
  const auto other = make_plan(protocol, numbered_words(40), {}, {1, 1});
  EXPECT_NE(spellings(one), spellings(other));
}

TEST(Plan, PutsPracticeFirstWithTheConditionsInTurn) {
  const auto practice = numbered_words(5, "practice").words;
  const auto plan = make_plan(protocol_with(3), numbered_words(9), practice, {4, 1});
  ASSERT_EQ(plan.size(), 14U);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    EXPECT_EQ(plan[i].index, i);
    EXPECT_EQ(plan[i].phase, i < 5 ? Phase::Practice : Phase::Main);
    EXPECT_EQ(plan[i].block, i < 5 ? 0 : 1);
  }
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(plan[i].word, practice[i]);
    EXPECT_EQ(plan[i].condition, i % 3);
  }
}

TEST(Plan, BeginsANewBlockAfterEveryBreak) {
  auto protocol = protocol_with(2);
  protocol.breaks.every_trials = 4;
  std::vector<int> blocks;
  for (const auto& trial : make_plan(protocol, numbered_words(10), {}, {1, 1})) {
    blocks.push_back(trial.block);
  }
  EXPECT_THAT(blocks, ElementsAre(0, 0, 0, 0, 1, 1, 1, 1, 2, 2));
}

TEST(Plan, GivesEveryTrialOfEverySessionANoiseOfItsOwn) {
  const auto protocol = protocol_with(3, Assignment::EveryCondition);
  std::set<Seed> seeds;
  for (int participant = 1; participant <= 10; ++participant) {
    for (int session = 1; session <= 3; ++session) {
      const auto plan = make_plan(
          protocol, numbered_words(50), numbered_words(4, "p").words, {participant, session});
      for (const auto& trial : plan) seeds.insert(trial.noise_seed);
    }
  }
  EXPECT_EQ(seeds.size(), 10U * 3U * 54U);
}

// In a random order of 414 trials in 3 equal conditions the expected number of neighbours in the
// same condition is 413 * 137/413 = 137; its standard deviation is about sqrt(413 * 1/3 * 2/3)
// = 9.6.
TEST(Plan, DoesNotClusterConditions) {
  double repetitions = 0;
  constexpr int kParticipants = 200;
  for (int participant = 1; participant <= kParticipants; ++participant) {
    const auto plan = make_plan(protocol_with(3), numbered_words(414), {}, {participant, 1});
    for (std::size_t i = 1; i < plan.size(); ++i) {
      if (plan[i].condition == plan[i - 1].condition) ++repetitions;
    }
  }
  EXPECT_NEAR(repetitions / kParticipants, 137.0, 4 * 9.6 / 14.1);  // four standard errors
}

TEST(Plan, GivesEachConditionTheSameMeanPosition) {
  std::vector<double> sums(3);
  constexpr int kParticipants = 200;
  for (int participant = 1; participant <= kParticipants; ++participant) {
    for (const auto& t : make_plan(protocol_with(3), numbered_words(60), {}, {participant, 1})) {
      sums.at(t.condition) += static_cast<double>(t.index);
    }
  }
  // A mean of 20 positions drawn without replacement from 0..59 has mean 29.5 and standard
  // deviation sqrt((60^2 - 1) / 12 / 20 * 40 / 59) = 3.19.
  for (const double sum : sums) EXPECT_NEAR(sum / kParticipants / 20, 29.5, 4 * 3.19 / 14.1);
}

TEST(Plan, RefusesASessionThatTheAssignmentDoesNotHave) {
  const auto words = numbered_words(3);
  EXPECT_THROW(static_cast<void>(make_plan(protocol_with(3), words, {}, {1, 2})), Error);
  EXPECT_THROW(static_cast<void>(make_plan(protocol_with(3), words, {}, {1, 0})), Error);
  EXPECT_THROW(static_cast<void>(make_plan(protocol_with(3), words, {}, {0, 1})), Error);
  EXPECT_THROW(static_cast<void>(make_plan(protocol_with(0), words, {}, {1, 1})), Error);
  const auto every = protocol_with(3, Assignment::EveryCondition);
  EXPECT_NO_THROW(static_cast<void>(make_plan(every, words, {}, {1, 3})));
  try {
    static_cast<void>(make_plan(every, words, {}, {1, 4}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("give a session number from 1 to 3"));
  }
}

TEST(Plan, OfNoWordsIsOnlyPractice) {
  const auto plan = make_plan(protocol_with(2), {}, numbered_words(2).words, {1, 1});
  EXPECT_EQ(plan.size(), 2U);
}

// A word that is dubbed onto another is a word of two kinds only where it is heard and seen.
TEST(Plan, PresentsWhatIsSeenWhereNothingIsHeard) {
  Protocol protocol;
  protocol.assignment = Assignment::EveryCondition;
  protocol.conditions.resize(3);
  protocol.conditions[0].auditory_talker = "festival:kal";
  protocol.conditions[1].visual_talker = "face";
  protocol.conditions[2].auditory_talker = "festival:kal";
  protocol.conditions[2].visual_talker = "face";
  const WordList words{.name = "dubbed",
                       .words = {{.spelling = "ba",
                                  .phones = {Phone::B, Phone::AA},
                                  .seen = SeenWord{"da", {Phone::D, Phone::AA}}}}};
  for (int session = 1; session <= 3; ++session) {
    const auto trial = make_plan(protocol, words, {}, {1, session}).at(0);
    if (trial.condition == 1) {
      EXPECT_EQ(trial.word.spelling, "da");
      EXPECT_EQ(trial.word.phones, (Pronunciation{Phone::D, Phone::AA}));
    } else {
      EXPECT_EQ(trial.word.spelling, "ba");
    }
    EXPECT_EQ(trial.word.seen.has_value(), trial.condition == 2);
  }
}

}  // namespace
}  // namespace bimodal::protocols

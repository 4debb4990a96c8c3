#include "protocols/observers/observer.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocols/observers/implied_confusions.hpp"
#include "stimuli/base/asset.hpp"

namespace bimodal::protocols {
namespace {

using enum Phone;
using ::testing::IsEmpty;

constexpr Presented kHeard{.heard = true, .seen = false, .snr = Decibels{-8}};
constexpr Presented kSeen{.heard = false, .seen = true, .snr = {}};
constexpr Presented kBoth{.heard = true, .seen = true, .snr = Decibels{-8}};

std::vector<Word> words(const std::string& file) {
  std::vector<Diagnostic> diagnostics;
  auto list = read_word_list(asset("stimuli/assets/words/" + file), diagnostics);
  EXPECT_THAT(diagnostics, IsEmpty());
  return list.words;
}

const std::vector<Word>& main_list() {
  static const auto list = words("monosyllables-414.json");
  return list;
}

const Observer& typical() {
  static const Observer observer = [] {
    std::vector<Diagnostic> diagnostics;
    auto description = read_observer(asset("protocols/observers/typical.json"), diagnostics);
    EXPECT_THAT(diagnostics, IsEmpty());
    return Observer{std::move(description), words("familiar-monosyllables.json")};
  }();
  return observer;
}

/// Hears perfectly but for B and P, which it takes for each other once in five times.
Observer toy() {
  ObserverDescription description{.name = "toy",
                                  .provenance = "test",
                                  .stated_snr = Decibels{-8},
                                  .slope_per_db = 0.25,
                                  .auditory = identity_confusions(),
                                  .visual = identity_confusions()};
  auto& auditory = description.auditory;
  auditory(B, B) = auditory(P, P) = 0.8;
  auditory(B, P) = auditory(P, B) = 0.2;
  const std::vector<Word> candidates{{"bat", {B, AE, T}},
                                     {"pat", {P, AE, T}},
                                     {"mat", {M, AE, T}},
                                     {"at", {AE, T}},
                                     {"cab", {K, AE, B}},
                                     {"cap", {K, AE, P}},
                                     {"brat", {B, R, AE, T}},
                                     {"pap", {P, AE, P}},
                                     {"bap", {B, AE, P}},
                                     {"matt", {M, AE, T}}};
  return Observer{std::move(description), candidates};
}

std::map<std::string, double> by_spelling(const std::vector<Observer::Answer>& answers) {
  std::map<std::string, double> probabilities;
  for (const auto& [word, probability] : answers) probabilities[word.spelling] = probability;
  return probabilities;
}

TEST(Observer, AnswersInProportionToTheProductOverThePositions) {
  const auto bat = by_spelling(toy().answers({"bat", {B, AE, T}}, kHeard));
  EXPECT_EQ(bat.size(), 2U);
  EXPECT_NEAR(bat.at("bat"), 0.8, 1e-12);
  EXPECT_NEAR(bat.at("pat"), 0.2, 1e-12);
  // "bab" is no candidate but the stimulus: .8 * .8, beside bap .8 * .2 and pap .2 * .2; sum .84
  const auto bab = by_spelling(toy().answers({"bab", {B, AE, B}}, kHeard));
  EXPECT_NEAR(bab.at("bab"), 0.64 / 0.84, 1e-12);
  EXPECT_NEAR(bab.at("bap"), 0.16 / 0.84, 1e-12);
  EXPECT_NEAR(bab.at("pap"), 0.04 / 0.84, 1e-12);
}

TEST(Observer, SharesAnAnswerEquallyAmongHomophones) {
  const auto mat = by_spelling(toy().answers({"mat", {M, AE, T}}, kHeard));
  EXPECT_NEAR(mat.at("mat"), 0.5, 1e-12);
  EXPECT_NEAR(mat.at("matt"), 0.5, 1e-12);
}

TEST(Observer, WithoutNoiseAnswersTheWordOrAHomophone) {
  const Presented clear{.heard = true, .seen = false, .snr = {}};
  Random random{1};
  for (const Word& stimulus : main_list()) {
    EXPECT_EQ(typical().answer(stimulus, clear, random).phones, stimulus.phones);
  }
}

TEST(Observer, AnswersAWordThatItDoesNotKnowOnlyInItsShape) {
  Random random{2};
  const Word strange{"zzyzx", {Z, IH, Z, AH, K, S}};
  EXPECT_EQ(typical().answer(strange, kSeen, random), strange);
}

TEST(Observer, GivesProbabilitiesThatSumToOneToWordsOfTheSameShape) {
  for (const Presented& presented : {kHeard, kSeen, kBoth, Presented{}}) {
    for (const Word& stimulus : main_list()) {
      double sum = 0.0;
      for (const auto& [word, probability] : typical().answers(stimulus, presented)) {
        ASSERT_EQ(word.phones.size(), stimulus.phones.size());
        for (std::size_t i = 0; i < word.phones.size(); ++i) {
          ASSERT_TRUE(same_kind(word.phones[i], stimulus.phones[i])) << word.spelling;
        }
        sum += probability;
      }
      EXPECT_NEAR(sum, 1.0, 1e-12) << stimulus.spelling;
    }
  }
}

TEST(Observer, DrawsEqualAnswersFromEqualSeeds) {
  const auto session = [](Seed seed) {
    Random random{seed};
    std::vector<Word> answers;
    for (const Word& stimulus : main_list()) {
      answers.push_back(typical().answer(stimulus, kHeard, random));
    }
    return answers;
  };
  EXPECT_EQ(session(7), session(7));
  EXPECT_NE(session(7), session(8));
}

TEST(Observer, DrawsAsOftenAsItsProbabilitiesSay) {
  const Word& stimulus = main_list().at(100);
  constexpr int kDraws = 40'000;
  std::map<std::string, int> counts;
  Random random{derive_seed(7, "observer test")};
  for (int i = 0; i < kDraws; ++i) {
    ++counts[typical().answer(stimulus, kHeard, random).spelling];
  }
  // Pearson's X2 over the answers expected at least 5 times, the others as one cell; mean df and
  // variance 2 df, so that df + 5 sqrt(2 df) is beyond the 99.99th centile here.
  double x2 = 0.0;
  double rare_expected = 0.0;
  int rare_count = kDraws;
  int cells = 1;
  for (const auto& [word, probability] : typical().answers(stimulus, kHeard)) {
    const double expected = kDraws * probability;
    if (expected < 5.0) {
      rare_expected += expected;
      continue;
    }
    const int count = counts[word.spelling];
    rare_count -= count;
    x2 += (count - expected) * (count - expected) / expected;
    ++cells;
  }
  x2 += (rare_count - rare_expected) * (rare_count - rare_expected) / rare_expected;
  ASSERT_GT(cells, 20);
  EXPECT_LT(x2, cells - 1 + 5.0 * std::sqrt(2.0 * (cells - 1)));
}

TEST(ImpliedConfusions, AreThoseOfAHandWorkedList) {
  const std::vector<Word> stimuli{{"bat", {B, AE, T}}, {"cab", {K, AE, B}}, {"at", {AE, T}}};
  const auto implied = implied_confusions(toy(), stimuli, kHeard);
  EXPECT_NEAR(implied.initial(B, B), 0.8, 1e-12);
  EXPECT_NEAR(implied.initial(B, P), 0.2, 1e-12);
  EXPECT_NEAR(implied.initial(K, K), 1.0, 1e-12);
  EXPECT_NEAR(implied.final(B, P), 0.2, 1e-12);
  EXPECT_NEAR(implied.final(T, T), 2.0, 1e-12);  // bat and at
  EXPECT_NEAR(implied.vowel(AE, AE), 3.0, 1e-12);
  EXPECT_NEAR(implied.correct, 0.8 + 0.8 + 1.0, 1e-12);
  EXPECT_EQ(implied.initial.row_sum(AE), 0.0);
}

TEST(ImpliedConfusions, CountEachStimulusPhoneAsOftenAsItStandsThere) {
  const auto implied = implied_confusions(typical(), main_list(), kBoth);
  double initial = 0.0;
  double vowel = 0.0;
  double final = 0.0;
  for (const Phone phone : all_phones()) {
    initial += implied.initial.row_sum(phone);
    vowel += implied.vowel.row_sum(phone);
    final += implied.final.row_sum(phone);
  }
  EXPECT_NEAR(initial, 414 - 16, 1e-9);  // 16 words begin with a vowel, 34 end with one:
  EXPECT_NEAR(vowel, 414, 1e-9);         // stimuli/assets/words/proportions.csv
  EXPECT_NEAR(final, 414 - 34, 1e-9);
}

TEST(ImpliedConfusions, OfTheTypicalObserverAreWhatItsRuleAimedAt) {
  // An independent implementation in Python gave .562, .128 and .827.
  const auto proportion = [](const Presented& presented) {
    return implied_confusions(typical(), main_list(), presented).correct / 414.0;
  };
  EXPECT_NEAR(proportion(kHeard), 0.562, 0.0005);
  EXPECT_NEAR(proportion(kSeen), 0.128, 0.0005);
  EXPECT_NEAR(proportion(kBoth), 0.827, 0.0005);
}

TEST(ImpliedConfusions, AreRecoveredFromSampledAnswersWithinSamplingError) {
  constexpr int kParticipants = 20;
  for (const Presented& presented : {kHeard, kSeen, kBoth}) {
    const auto implied = implied_confusions(typical(), main_list(), presented);
    PhoneTable initial;
    PhoneTable final;
    Random random{11};
    for (int participant = 0; participant < kParticipants; ++participant) {
      for (const Word& stimulus : main_list()) {
        const Word answer = typical().answer(stimulus, presented, random);
        const auto& given = stimulus.phones;
        if (is_consonant(given.front())) initial(given.front(), answer.phones.front()) += 1.0;
        if (is_consonant(given.back())) final(given.back(), answer.phones.back()) += 1.0;
      }
    }
    for (const Phone stimulus : all_phones()) {
      for (const Phone response : all_phones()) {
        for (const auto& [counted, expected_once] :
             {std::pair{initial(stimulus, response), implied.initial(stimulus, response)},
              std::pair{final(stimulus, response), implied.final(stimulus, response)}}) {
          // A sum of independent yes-or-no draws has a variance of at most its mean. The continuity
          // of 1 lets a rare cell hold a single count; 3 x 2 x 25 x 25 cells want 5 sigma.
          const double expected = kParticipants * expected_once;
          EXPECT_LE(std::abs(counted - expected), 1.0 + 5.0 * std::sqrt(expected))
              << symbol(stimulus) << ' ' << symbol(response);
        }
      }
    }
  }
}

}  // namespace
}  // namespace bimodal::protocols

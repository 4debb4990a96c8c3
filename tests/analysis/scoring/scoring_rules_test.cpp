#include "analysis/scoring/scoring_rules.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "analysis/scoring/score.hpp"
#include "tests/analysis/examples.hpp"

namespace bimodal::analysis {
namespace {

using examples::trial;
using Outcome = UnitScore::Outcome;

class ScoreByRules : public testing::Test {
 protected:
  Score answer(const std::string& word,
               std::string_view spoken,
               const std::string& response,
               const ScoringRules& rules) {
    return score(trial(word, spoken, response), dictionary_, rules);
  }

  static ScoringRules tolerate(Tolerance tolerance) {
    ScoringRules rules;
    rules.tolerate(tolerance);
    return rules;
  }

 private:
  WrittenFiles folder_;
  Dictionary dictionary_ = examples::dictionary(folder_);
};

TEST_F(ScoreByRules, ATolerantRuleMakesAllPhonesOfTheWordCorrect) {
  EXPECT_EQ(answer("bat", "B AE T", "bats", {}).verdict, Verdict::Unknown);
  const auto scored = answer("bat", "B AE T", "bats", tolerate(Tolerance::Plural));
  EXPECT_EQ(scored.verdict, Verdict::Tolerated);
  EXPECT_EQ(scored.tolerance, Tolerance::Plural);
  EXPECT_TRUE(scored.word_correct());
  EXPECT_EQ(scored.phones_correct, 3);
  EXPECT_EQ(scored.places.at(2).answer, Phone::T);
}

TEST_F(ScoreByRules, WhatIsCorrectOrSoundsSoNeedsNoTolerance) {
  const auto rules = tolerate(Tolerance::DoubleLetters);
  EXPECT_EQ(answer("bee", "B IY", "bee", rules).verdict, Verdict::Correct);
  EXPECT_EQ(answer("two", "T UW", "too", rules).verdict, Verdict::Homophone);
  EXPECT_EQ(answer("stew", "S T UW", "sttew", rules).tolerance, Tolerance::DoubleLetters);
  EXPECT_EQ(answer("reed", "R IY D", "red", rules).verdict, Verdict::Wrong);  // another word
}

TEST_F(ScoreByRules, HomophonesMayCountAsWrong) {
  ScoringRules rules;
  rules.homophones = false;
  const auto scored = answer("two", "T UW", "too", rules);
  EXPECT_EQ(scored.verdict, Verdict::Wrong);
  EXPECT_EQ(scored.phones_correct, 2);  // its phones are those presented all the same
  EXPECT_EQ(answer("two", "T UW", "two", rules).verdict, Verdict::Correct);
}

TEST_F(ScoreByRules, NumbersSoundAsTheyAreSaid) {
  EXPECT_EQ(answer("two", "T UW", "2", {}).verdict, Verdict::Unknown);
  const auto rules = tolerate(Tolerance::Numbers);
  EXPECT_EQ(answer("unlisted", "T UW", "2", rules).verdict, Verdict::Homophone);
  EXPECT_EQ(answer("two", "T UW N", "2", rules).verdict, Verdict::Tolerated);
  const auto scored = answer("bat", "B AE T", "8", rules);  // eight
  EXPECT_EQ(scored.verdict, Verdict::Wrong);
  EXPECT_EQ(scored.phones_correct, 1);
}

TEST_F(ScoreByRules, SpacesNeverCountAndCompoundsSoundAsTheirParts) {
  EXPECT_EQ(answer("stew", "S T UW", "s t-ew", {}).verdict, Verdict::Correct);
  EXPECT_EQ(answer("unlisted", "B IY R EH D", "bee red", {}).verdict, Verdict::Unknown);
  const auto rules = tolerate(Tolerance::Compounds);
  EXPECT_EQ(answer("unlisted", "B IY R EH D", "bee-red", rules).verdict, Verdict::Homophone);
  const auto scored = answer("bat", "B AE T", "bat two", rules);
  EXPECT_EQ(scored.verdict, Verdict::Wrong);
  EXPECT_EQ(scored.phones_correct, 3);
  EXPECT_EQ(scored.insertions, 2);
  EXPECT_EQ(answer("bat", "B AE T", "bat xyz", rules).verdict, Verdict::Unknown);
}

TEST_F(ScoreByRules, LetterToSoundRulesSayWhatTheDictionaryLacks) {
  ScoringRules rules;
  rules.out_of_dictionary = OutOfDictionary::LetterToSound;
  const auto scored = answer("bat", "B AE T", "zat", rules);  // Z AE T
  EXPECT_EQ(scored.verdict, Verdict::Unknown);
  EXPECT_FALSE(scored.word_correct());
  EXPECT_EQ(scored.phones_correct, 2);
  EXPECT_EQ(scored.places.at(0).answer, Phone::Z);
  EXPECT_EQ(answer("debt", "D EH T", "det", rules).verdict, Verdict::Homophone);
  rules.homophones = false;
  EXPECT_EQ(answer("debt", "D EH T", "det", rules).verdict, Verdict::Unknown);
}

TEST_F(ScoreByRules, LetterToSoundRulesWriteAsTheDictionary) {
  ScoringRules rules;
  rules.out_of_dictionary = OutOfDictionary::LetterToSound;
  const auto scored = answer("bat", "B AE T", "whab", rules);
  ASSERT_EQ(scored.said.size(), 1U);
  EXPECT_EQ(scored.said.front().phones.front(), Phone::W);
}

TEST_F(ScoreByRules, SharesOfAnAmbiguousPlaceSumToOne) {
  // S T UW against B IY: one of S and T became B; two alignments.
  const auto scored = answer("stew", "S T UW", "bee", {});
  EXPECT_TRUE(scored.ambiguous());
  ASSERT_EQ(scored.shares.size(), 4U);
  for (const auto& share : scored.shares) EXPECT_EQ(share.share, 0.5);
  EXPECT_EQ(scored.places.at(0).outcome, Outcome::Ambiguous);
  EXPECT_EQ(scored.places.at(2).answer, Phone::IY);
}

TEST_F(ScoreByRules, EquallyGoodPronunciationsShareAPlace) {
  const auto scored = answer("rid", "R IH D", "read", {});  // R EH D or R IY D
  ASSERT_EQ(scored.said.size(), 2U);
  EXPECT_EQ(scored.said[0].share, 0.5);
  ASSERT_EQ(scored.shares.size(), 2U);
  EXPECT_EQ(scored.shares[0].place, 1U);
}

TEST_F(ScoreByRules, FeaturesTellWhichPhoneWasMeant) {
  EXPECT_TRUE(answer("stew", "S T UW", "bee", {}).ambiguous());
  ScoringRules rules;
  rules.costs = AlignmentCosts::Feature;
  const auto scored = answer("stew", "S T UW", "bee", rules);
  // S to B differs in all three features, T to B in two.
  EXPECT_EQ(scored.places.at(0).outcome, Outcome::Deleted);
  EXPECT_EQ(scored.places.at(1).answer, Phone::B);
}

TEST_F(ScoreByRules, AStimulusWithoutPhonesIsScoredAsAWordAlone) {
  for (const auto* const response : {"bada", "bat", "", "gaga"}) {
    const auto scored = answer("bada", "", response, {});
    EXPECT_EQ(scored.word_correct(), std::string_view{response} == "bada");
    EXPECT_EQ(scored.phones, 0);
    EXPECT_EQ(scored.phones_correct, std::nullopt);
    EXPECT_EQ(scored.insertions, 0);
    EXPECT_TRUE(scored.places.empty());
    EXPECT_FALSE(scored.units[0] || scored.units[1] || scored.units[2]);
  }
  EXPECT_EQ(answer("bada", "", "badas", tolerate(Tolerance::Plural)).verdict, Verdict::Tolerated);
}

}  // namespace
}  // namespace bimodal::analysis

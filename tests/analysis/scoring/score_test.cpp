#include "analysis/scoring/score.hpp"

#include <ostream>

#include <gtest/gtest.h>

#include "tests/analysis/examples.hpp"

namespace bimodal::analysis {

static void PrintTo(Verdict verdict, std::ostream* out) {
  *out << name(verdict);
}

namespace {

using examples::trial;
using Outcome = UnitScore::Outcome;

class ScoreWords : public testing::Test {
 protected:
  Score answer(const std::string& word, std::string_view spoken, const std::string& response) {
    return score(trial(word, spoken, response), dictionary_);
  }

  static UnitScore unit(const Score& score, Unit unit) {
    return score.units.at(static_cast<std::size_t>(unit)).value();
  }

 private:
  WrittenFiles folder_;
  Dictionary dictionary_ = examples::dictionary(folder_);
};

TEST_F(ScoreWords, JudgesWordsBySpellingAndSound) {
  EXPECT_EQ(answer("stew", "S T UW", " STEW! ").verdict, Verdict::Correct);
  EXPECT_EQ(answer("two", "T UW", "too").verdict, Verdict::Homophone);
  EXPECT_EQ(answer("two", "T UW", "stew").verdict, Verdict::Wrong);
  EXPECT_EQ(answer("two", "T UW", "tue").verdict, Verdict::Unknown);
  EXPECT_EQ(answer("two", "T UW", " . ").verdict, Verdict::Omission);
  EXPECT_EQ(answer("can't", "K AE N T", "can\xe2\x80\x99t").verdict, Verdict::Correct);
  EXPECT_EQ(answer("well", "W EH L", "we'll").verdict, Verdict::Wrong);
  EXPECT_EQ(answer("don't", "D OW N T", "dont").verdict, Verdict::Correct);
}

TEST_F(ScoreWords, TakesForHomophonesWhatSoundsAsWasPresented) {
  EXPECT_EQ(answer("read", "R EH D", "red").verdict, Verdict::Homophone);
  EXPECT_EQ(answer("read", "R IY D", "red").verdict, Verdict::Wrong);
  EXPECT_EQ(answer("read", "R EH D", "read").verdict, Verdict::Correct);
  EXPECT_EQ(answer("read", "R IY D", "reed").verdict, Verdict::Homophone);
  EXPECT_EQ(answer("lead", "L IY D", "red").verdict, Verdict::Wrong);
}

TEST_F(ScoreWords, TakesThePresentedPhonesEvenIfTheDictionaryHasOthers) {
  EXPECT_EQ(answer("unlisted", "T UW", "too").verdict, Verdict::Homophone);
  EXPECT_EQ(answer("unlisted", "S T UW N", "unlisted").verdict, Verdict::Correct);
}

TEST_F(ScoreWords, GivesEveryPhoneOfACorrectWordAsPresented) {
  const auto scored = answer("lead", "R IY D", "read");  // a homophone by its second pronunciation
  EXPECT_EQ(scored.phones_correct, 3);
  EXPECT_EQ(unit(scored, Unit::Vowel).answer, Phone::IY);
  EXPECT_EQ(unit(answer("read", "R IY D", "red"), Unit::Vowel).answer, Phone::EH);
}

TEST_F(ScoreWords, ScoresThePhonesOfAWrongWord) {
  const auto scored = answer("bed", "B EH D", "mat");
  EXPECT_EQ(scored.phones_correct, 0);
  EXPECT_EQ(unit(scored, Unit::ConsonantInitial).answer, Phone::M);
  EXPECT_EQ(unit(scored, Unit::Vowel).answer, Phone::AE);
  EXPECT_EQ(unit(scored, Unit::ConsonantFinal).answer, Phone::T);
}

TEST_F(ScoreWords, CallsAPhoneThatTheAnswerLacksDeleted) {
  const auto scored = answer("stew", "S T UW", "two");
  EXPECT_EQ(scored.phones_correct, 2);
  EXPECT_EQ(unit(scored, Unit::ConsonantInitial).outcome, Outcome::Deleted);
  EXPECT_EQ(unit(scored, Unit::Vowel).outcome, Outcome::Answered);
  EXPECT_FALSE(scored.units.at(static_cast<std::size_t>(Unit::ConsonantFinal)).has_value());
}

TEST_F(ScoreWords, LeavesUnknownAnswersOutOfPhonemeScoresAndCallsThemOther) {
  const auto scored = answer("bed", "B EH D", "bedd");
  EXPECT_EQ(scored.phones_correct, std::nullopt);
  EXPECT_EQ(unit(scored, Unit::Vowel).outcome, Outcome::Other);
}

TEST_F(ScoreWords, CountsNoPhoneOfAnOmissionAndCallsItBlank) {
  const auto scored = answer("bed", "B EH D", "");
  EXPECT_EQ(scored.phones_correct, 0);
  EXPECT_EQ(scored.phones, 3);
  EXPECT_EQ(unit(scored, Unit::ConsonantFinal).outcome, Outcome::Blank);
}

TEST_F(ScoreWords, CallsPlacesAmbiguousWhereEquallyGoodAlignmentsDisagree) {
  const auto scored = answer("stew", "S T UW", "blow");  // S T against B L is clear
  EXPECT_EQ(unit(scored, Unit::ConsonantInitial).answer, Phone::B);
  const auto unclear = answer("stew", "S T UW", "bee");  // did S or T become B?
  EXPECT_EQ(unit(unclear, Unit::ConsonantInitial).outcome, Outcome::Ambiguous);
  EXPECT_EQ(unit(unclear, Unit::Vowel).answer, Phone::IY);
}

TEST(PlaceOf, FindsTheUnitsOfAWord) {
  const auto stew = examples::phones("S T UW");
  EXPECT_EQ(place_of(Unit::ConsonantInitial, stew), 0U);
  EXPECT_EQ(place_of(Unit::Vowel, stew), 2U);
  EXPECT_EQ(place_of(Unit::ConsonantFinal, stew), std::nullopt);
  const auto asks = examples::phones("AE S K S");
  EXPECT_EQ(place_of(Unit::ConsonantInitial, asks), std::nullopt);
  EXPECT_EQ(place_of(Unit::ConsonantFinal, asks), 3U);
  EXPECT_EQ(place_of(Unit::Vowel, {}), std::nullopt);
}

TEST(UnitName, IsReadBack) {
  for (const Unit unit : kUnits) EXPECT_EQ(unit_from_name(name(unit)), unit);
  EXPECT_EQ(unit_from_name("consonant"), std::nullopt);
}

}  // namespace
}  // namespace bimodal::analysis

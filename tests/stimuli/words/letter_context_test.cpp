#include "stimuli/words/letter_context.hpp"

#include <gtest/gtest.h>

namespace bimodal {
namespace {

bool before(std::string_view context, std::string_view text) {
  return stands_before(context_before(context), text, text.size());
}

bool after(std::string_view context, std::string_view text) {
  return stands_after(context_after(context), text, 0);
}

TEST(LetterContext, OfNothingMatchesEverywhere) {
  EXPECT_TRUE(before("", ""));
  EXPECT_TRUE(after("", "ABC"));
}

TEST(LetterContext, LettersBlanksAndApostrophesStandForThemselves) {
  EXPECT_TRUE(after("EN", "ENTRY"));
  EXPECT_FALSE(after("EN", "E"));
  EXPECT_TRUE(before(" SU", " SU"));
  EXPECT_FALSE(before(" SU", "ISU"));
  EXPECT_TRUE(before("' ", " DON ' "));
}

TEST(LetterContext, NumberSignIsOneOrMoreVowelsWithY) {
  EXPECT_TRUE(after("#", "Y"));
  EXPECT_TRUE(after("#T", "EAUT"));
  EXPECT_FALSE(after("#", "T"));
  EXPECT_FALSE(after("#", ""));
}

TEST(LetterContext, AsteriskIsOneOrMoreConsonantsAndColonMayBeNone) {
  EXPECT_TRUE(after("*A", "STRA"));
  EXPECT_FALSE(after("*A", "A"));
  EXPECT_TRUE(after(":A", "STRA"));
  EXPECT_TRUE(after(":A", "A"));
  EXPECT_TRUE(before(" :", " STR"));
  EXPECT_TRUE(before(" :", " "));
  EXPECT_FALSE(before(" :", " STRA"));
}

TEST(LetterContext, CaretIsOneConsonantAndFullStopAVoicedOne) {
  EXPECT_TRUE(after("^A", "TA"));
  EXPECT_FALSE(after("^A", "STA"));
  EXPECT_FALSE(after("^", "Y"));
  EXPECT_TRUE(before(".", "B"));
  EXPECT_FALSE(before(".", "T"));
}

TEST(LetterContext, DollarIsAConsonantAndThenEOrI) {
  EXPECT_TRUE(after("$", "TE"));
  EXPECT_TRUE(after("$", "TI"));
  EXPECT_FALSE(after("$", "TA"));
  EXPECT_FALSE(after("$", "ET"));
  EXPECT_TRUE(before("$", "TE"));
  EXPECT_FALSE(before("$", "ET"));
}

TEST(LetterContext, PlusIsAFrontVowel) {
  for (const std::string_view vowel : {"E", "I", "Y"}) EXPECT_TRUE(after("+", vowel));
  for (const std::string_view vowel : {"A", "O", "U"}) EXPECT_FALSE(after("+", vowel));
}

TEST(LetterContext, AmpersandAndAtAreOneLetterOrTwo) {
  for (const std::string_view sibilant : {"S", "C", "G", "Z", "X", "J", "CH", "SH"}) {
    EXPECT_TRUE(before("A&", std::string{"A"}.append(sibilant))) << sibilant;
  }
  EXPECT_FALSE(before("A&", "AHC"));
  EXPECT_FALSE(before("&", "T"));
  for (const std::string_view letters :
       {"T", "S", "R", "D", "L", "Z", "N", "J", "TH", "CH", "SH"}) {
    EXPECT_TRUE(before("A@", std::string{"A"}.append(letters))) << letters;
  }
  EXPECT_FALSE(before("@", "K"));
}

TEST(LetterContext, PercentIsASuffixThatEndsTheWord) {
  for (const std::string_view suffix : {"E ", "ER ", "ES ", "ED ", "ING "}) {
    EXPECT_TRUE(after("%", suffix)) << suffix;
  }
  EXPECT_FALSE(after("%", "E"));
  EXPECT_FALSE(after("%", "EN "));
  EXPECT_FALSE(after("%", "INGS "));
}

TEST(LetterContext, SymbolsGiveLettersBackThatOthersNeed) {
  // Two vowels for "##": the nearer "#" must not keep both. One of the consonants is for "^".
  EXPECT_TRUE(before("#^:##", "EGREE"));
  EXPECT_FALSE(before("#^:##", "EGRE"));
  EXPECT_FALSE(before("#^:##", "EE"));
  EXPECT_TRUE(after("^:^#", "STRA"));
  EXPECT_TRUE(after("*T", "STT"));
  EXPECT_TRUE(after("#E", "AEE"));
  EXPECT_TRUE(before("#:&", "ACH"));  // "&" as H alone would leave nothing; as CH it is right
}

}  // namespace
}  // namespace bimodal

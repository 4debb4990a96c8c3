#include "stimuli/words/number_words.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "stimuli/words/dictionary.hpp"

namespace bimodal {
namespace {

std::string said(std::string_view number) {
  return fmt::format("{}", fmt::join(number_words(number), " "));
}

TEST(NumberWords, SayWholeNumbersAsAmericansDo) {
  EXPECT_EQ(said("0"), "zero");
  EXPECT_EQ(said("7"), "seven");
  EXPECT_EQ(said("10"), "ten");
  EXPECT_EQ(said("13"), "thirteen");
  EXPECT_EQ(said("22"), "twenty two");
  EXPECT_EQ(said("40"), "forty");
  EXPECT_EQ(said("100"), "one hundred");
  EXPECT_EQ(said("414"), "four hundred fourteen");
  EXPECT_EQ(said("1990"), "one thousand nine hundred ninety");
  EXPECT_EQ(said("20000"), "twenty thousand");
  EXPECT_EQ(said("999999"), "nine hundred ninety nine thousand nine hundred ninety nine");
}

TEST(NumberWords, SayLongNumbersAndThoseWithALeadingZeroDigitByDigit) {
  EXPECT_EQ(said("1000000"), "one zero zero zero zero zero zero");
  EXPECT_EQ(said("007"), "zero zero seven");
  EXPECT_EQ(said("00"), "zero zero");
}

TEST(NumberWords, SayWhatFollowsThePointDigitByDigit) {
  EXPECT_EQ(said("3.14"), "three point one four");
  EXPECT_EQ(said("0.5"), "zero point five");
}

TEST(NumberWords, AreAllInTheDictionary) {
  const Dictionary dictionary{Dictionary::installed()};
  for (int number = 0; number < 2'000; ++number) {
    for (const auto word : number_words(fmt::format("{}.5", number))) {
      ASSERT_FALSE(dictionary.pronunciations(word).empty()) << word;
    }
  }
}

}  // namespace
}  // namespace bimodal

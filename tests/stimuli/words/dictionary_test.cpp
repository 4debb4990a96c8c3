#include "stimuli/words/dictionary.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::filesystem::path written(std::string_view text) {
  const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
  auto file = std::filesystem::path{::testing::TempDir()} /
              (std::string{"bimodal-dictionary-"} + test->name() + ".dict");
  std::ofstream{file} << text;
  return file;
}

std::string message_about(std::string_view text) {
  try {
    const Dictionary dictionary{written(text)};
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Dictionary, ReadsAlternativesThatStandApartInTheOrderOfTheFile) {
  const Dictionary dictionary{
      written("read R EH D\nread's R IY D Z\nread(2) R IY D\r\nred R EH D\n\n;;; a comment\n")};
  EXPECT_THAT(dictionary.spellings(), ElementsAre("read", "read's", "red"));
  EXPECT_THAT(dictionary.pronunciations("read"),
              ElementsAre(Pronunciation{Phone::R, Phone::EH, Phone::D},
                          Pronunciation{Phone::R, Phone::IY, Phone::D}));
  EXPECT_THAT(dictionary.pronunciations("rea"), IsEmpty());
  EXPECT_THAT(dictionary.pronunciations(""), IsEmpty());
}

TEST(Dictionary, ReadsTheOriginalCmuFormatWithCapitalsAndStress) {
  const Dictionary dictionary{written("STEW  S T UW1\nABOUT  AH0 B AW1 T\n")};
  EXPECT_THAT(dictionary.pronunciations("stew"),
              ElementsAre(Pronunciation{Phone::S, Phone::T, Phone::UW}));
  EXPECT_THAT(dictionary.pronunciations("about"),
              ElementsAre(Pronunciation{Phone::AH, Phone::B, Phone::AW, Phone::T}));
}

TEST(Dictionary, CallsWordsHomophonesThatShareOnePronunciation) {
  const Dictionary dictionary{written("lead L EH D\nlead(2) L IY D\nled L EH D\nlid L IH D\n")};
  EXPECT_TRUE(dictionary.homophones("lead", "led"));
  EXPECT_TRUE(dictionary.homophones("led", "lead"));
  EXPECT_FALSE(dictionary.homophones("lid", "led"));
  EXPECT_TRUE(dictionary.homophones("blorp", "blorp"));
  EXPECT_FALSE(dictionary.homophones("blorp", "led"));
}

TEST(Dictionary, NamesTheLineOfAMistake) {
  EXPECT_THAT(message_about("stew S T UW\nsoup S QQ P\n"),
              AllOf(HasSubstr(".dict:2:"), HasSubstr("\"QQ\" is not a phone")));
  EXPECT_THAT(message_about("stew S T UW\n\nsoup\n"),
              AllOf(HasSubstr(".dict:3:"), HasSubstr("\"soup\" has no phones")));
  EXPECT_THAT(message_about("stew S rest UW\n"), HasSubstr("\"rest\" is not a phone"));
  EXPECT_THAT(message_about("(2) S T UW\n"), HasSubstr("no spelling"));
  EXPECT_THAT(message_about(""), HasSubstr("no words"));
}

TEST(Dictionary, IsInstalledWhereDebianPutsIt) {
  const Dictionary dictionary{Dictionary::installed()};
  // cut -d' ' -f1 cmudict-en-us.dict | sed 's/([0-9]*)$//' | LC_ALL=C sort -u | wc -l
  EXPECT_EQ(dictionary.spellings().size(), 125'945U);
  EXPECT_TRUE(std::ranges::is_sorted(dictionary.spellings()));
  EXPECT_TRUE(dictionary.homophones("sea", "see"));
  EXPECT_TRUE(dictionary.homophones("which", "witch"));
  EXPECT_FALSE(dictionary.homophones("stew", "soup"));
  EXPECT_THAT(dictionary.pronunciations("smooth"),
              ElementsAre(Pronunciation{Phone::S, Phone::M, Phone::UW, Phone::DH}));
}

TEST(IsOneSyllable, CountsVowels) {
  EXPECT_TRUE(is_one_syllable(Pronunciation{Phone::S, Phone::T, Phone::UW}));
  EXPECT_TRUE(is_one_syllable(Pronunciation{Phone::ER}));
  EXPECT_FALSE(is_one_syllable(Pronunciation{Phone::S, Phone::T}));
  EXPECT_FALSE(is_one_syllable(Pronunciation{Phone::AH, Phone::L, Phone::OW}));
  EXPECT_FALSE(is_one_syllable({}));
}

}  // namespace
}  // namespace bimodal

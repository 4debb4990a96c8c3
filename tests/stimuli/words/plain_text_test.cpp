#include "stimuli/words/plain_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string message_about(std::string_view text) {
  try {
    (void)plain_text(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(PlainText, KeepsWhatCanBeSaid) {
  EXPECT_EQ(plain_text("Don't stop, screw-driver 22? No."), "Don't stop, screw-driver 22? No.");
}

TEST(PlainText, UnderstandsTypography) {
  EXPECT_EQ(plain_text("don\u2019t"), "don't");
  EXPECT_EQ(plain_text("\uFEFFstop\u2014now\u2026"), "stop--now...");
  EXPECT_EQ(plain_text("\u201Cno\u201D\u00A0way\twell\r\n"), " no  way well  ");
}

TEST(PlainText, MakesCommasAndFullStopsOfOtherPauses) {
  EXPECT_EQ(plain_text("no! so: a; (b)"), "no. so, a, ,b,");
  EXPECT_EQ(plain_text("and/or [sic] \"x\""), "and or  sic   x ");
}

TEST(PlainText, KeepsApostrophesWithinWordsOnly) {
  EXPECT_EQ(plain_text("'be' so, dogs' don't"), " be  so, dogs  don't");
}

TEST(PlainText, KeepsTheChoiceOfAPronunciation) {
  EXPECT_EQ(plain_text("read(2) it"), "read(2) it");
  EXPECT_EQ(plain_text("read (2) it(x) (3)"), "read ,2, it,x, ,3,");
  EXPECT_EQ(choice_length("read(12)", 4), 4U);
  EXPECT_EQ(choice_length("read()", 4), 0U);
  EXPECT_EQ(choice_length("read(2", 4), 0U);
  EXPECT_EQ(choice_length("read(123)", 4), 0U);
}

TEST(PlainText, RefusesTextWithoutWords) {
  for (const auto* const text : {"", "  ", "!?", "\u2026", "'"}) {
    EXPECT_THAT(message_about(text),
                AllOf(HasSubstr("there are no words"), HasSubstr("temporary food stew")))
        << text;
  }
}

TEST(PlainText, NamesTheCharacterThatNobodyKnowsHowToSay) {
  EXPECT_THAT(message_about("50%"),
              AllOf(HasSubstr("\"%\""), HasSubstr("character 3"), HasSubstr("as a word")));
  EXPECT_THAT(message_about("a caf\u00E9"),
              AllOf(HasSubstr("\"\u00E9\""), HasSubstr("character 6"), HasSubstr("A to Z")));
  EXPECT_THAT(message_about("\u03C9"), HasSubstr("\"\u03C9\""));
}

TEST(PlainText, RefusesWhatIsNoText) {
  EXPECT_THAT(message_about("stew\xFF"), HasSubstr("UTF-8"));
  EXPECT_THAT(message_about(std::string_view{"st\0ew", 5}), HasSubstr("control characters"));
  EXPECT_THAT(message_about(std::string(101, 'a')), HasSubstr("more than 100 letters"));
  EXPECT_THAT(message_about(std::string(100'001, ' ')), HasSubstr("in parts"));
}

}  // namespace
}  // namespace bimodal

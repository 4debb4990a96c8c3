#include "stimuli/words/text_phones.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class TextPhones : public testing::Test {
 protected:
  static const Dictionary& dictionary() {
    static const Dictionary installed{Dictionary::installed()};
    return installed;
  }

  static const LetterToSound& rules() {
    static const auto shipped = LetterToSound::shipped();
    return shipped;
  }

  static std::vector<PronouncedWord> read(std::string_view text) {
    return phones_by_dictionary(text, dictionary(), rules());
  }

  static std::string shown(const std::vector<PronouncedWord>& words) {
    std::string phones;
    for (const auto& word : words) phones += (phones.empty() ? "" : " | ") + spell(word.phones);
    return phones;
  }

  static std::string said(std::string_view text) { return shown(read(text)); }

  static std::vector<std::string> written(std::string_view text) {
    std::vector<std::string> words;
    for (const auto& word : read(text)) words.push_back(word.written);
    return words;
  }

  template <typename Deed>
  static std::string message_of(const Deed& deed) {
    try {
      (void)deed();
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  static std::string message_about(std::string_view text) {
    return message_of([&] { return read(text); });
  }
};

TEST_F(TextPhones, AreThoseOfTheDictionaryInAnyCase) {
  EXPECT_EQ(said("stew"), "S T UW");
  EXPECT_EQ(said("Temporary Food STEW"), "T EH M P ER EH R IY | F UW D | S T UW");
  EXPECT_EQ(said("don\u2019t"), "D OW N T");
  EXPECT_EQ(said("Twenty Two"), "T W EH N T IY | T UW");
}

TEST_F(TextPhones, AreTheFirstPronunciationOrTheOneThatTheTextChooses) {
  EXPECT_EQ(said("read"), "R EH D");
  EXPECT_EQ(said("read(1)"), "R EH D");
  EXPECT_EQ(said("I read(2) it"), "AY | R IY D | IH T");
  EXPECT_THAT(message_about("read(3)"),
              AllOf(HasSubstr("2 pronunciations of \"read\""), HasSubstr("up to 2")));
  EXPECT_THAT(message_about("read(0)"), HasSubstr("\"read(0)\""));
  EXPECT_THAT(message_about("zorblat(2)"), HasSubstr("has no \"zorblat\""));
}

TEST_F(TextPhones, OfUnknownWordsComeFromTheRulesAndSaySo) {
  EXPECT_THAT(
      read("Zorblat stew"),
      ElementsAre(
          PronouncedWord{
              .written = "Zorblat",
              .phones = {Phone::Z, Phone::AO, Phone::R, Phone::B, Phone::L, Phone::AE, Phone::T},
              .source = PhoneSource::Rules},
          PronouncedWord{.written = "stew",
                         .phones = {Phone::S, Phone::T, Phone::UW},
                         .source = PhoneSource::Dictionary}));
}

TEST_F(TextPhones, OfHyphenatedWordsAreThoseOfTheirPartsWhereTheDictionaryHasNoWhole) {
  EXPECT_THAT(written("stew-boot"), ElementsAre("stew", "boot"));
  EXPECT_THAT(written("stew-zorblat-22"), ElementsAre("stew", "zorblat", "twenty", "two"));
}

TEST_F(TextPhones, OfNumbersAreThoseOfTheirWords) {
  EXPECT_THAT(written("22"), ElementsAre("twenty", "two"));
  EXPECT_THAT(written("1,000 words"), ElementsAre("one", "thousand", "words"));
  EXPECT_THAT(written("3.5."), ElementsAre("three", "point", "five"));
  EXPECT_THAT(written("1,2"), ElementsAre("one", "two"));
  EXPECT_THAT(written("1.2.3"), ElementsAre("one", "point", "two", "three"));
  EXPECT_THAT(message_about("the 3rd"), AllOf(HasSubstr("\"3rd\""), HasSubstr("\"third\"")));
}

TEST_F(TextPhones, KeepThePausesOfPunctuation) {
  std::vector<Pause> pauses;
  for (const auto& word : read(", stew, boot! beet? a - b c?!")) pauses.push_back(word.after);
  EXPECT_THAT(
      pauses,
      ElementsAre(
          Pause::Comma, Pause::Stop, Pause::Question, Pause::Dash, Pause::None, Pause::Question));
}

TEST_F(TextPhones, HaveNoPauseWithinAbbreviationsAndNumbers) {
  const auto pauses = [](const std::vector<PronouncedWord>& words) {
    std::vector<Pause> found;
    for (const auto& word : words) found.push_back(word.after);
    return found;
  };
  using enum Pause;
  EXPECT_THAT(pauses(read("U.S.A. it")), ElementsAre(None, None, Stop, None));
  EXPECT_THAT(pauses(phones_by_rules("U.S.A. it", rules())), ElementsAre(None, None, Stop, None));
  EXPECT_THAT(pauses(phones_by_rules("10,000. it", rules())), ElementsAre(None, Stop, None));
  EXPECT_THAT(pauses(phones_by_rules("3.14, it", rules())), ElementsAre(None, Comma, None));
  EXPECT_THAT(pauses(phones_by_rules("stew,boot.beet", rules())), ElementsAre(Comma, Stop, None));
  EXPECT_THAT(pauses(read("stew,boot.beet")), ElementsAre(Comma, Stop, None));
}

TEST_F(TextPhones, NeedWords) {
  EXPECT_THAT(message_about(""), HasSubstr("there are no words"));
  EXPECT_THAT(message_about("!?"), HasSubstr("there are no words"));
  EXPECT_THAT(message_of([] { return phones_by_rules("!?", rules()); }),
              HasSubstr("there are no words"));
}

TEST_F(TextPhones, ByRuleAreWithoutTheDictionary) {
  EXPECT_EQ(shown(phones_by_rules("Temporary Food Stew, 22", rules())),
            "T EH M P AO R EH R IY | F UH D | S T UW | T UW T UW");
  EXPECT_THAT(message_of([] { return phones_by_rules("read(2)", rules()); }),
              HasSubstr("\"(2)\" chooses nothing"));
  EXPECT_THAT(message_of([] { return phones_by_rules("h", rules()); }),
              AllOf(HasSubstr("\"h\" silent"), HasSubstr("aitch")));
}

TEST_F(TextPhones, OfAnyTextAreWordsOrAnError) {
  static constexpr std::string_view kLetters = "aeiosthnrd AEST 0123,.?!'()-%;:\"\xE2\x80\x99\n";
  Random random{414};
  int readable = 0;
  for (int i = 0; i < 10'000; ++i) {
    std::string text;
    for (auto length = random.below(20); length > 0; --length) {
      text += kLetters[random.below(kLetters.size())];
    }
    try {
      ASSERT_FALSE(read(text).empty()) << text;
      ++readable;
    } catch (const Error& error) {
      ASSERT_STRNE(error.what(), "");
    }
    try {
      ASSERT_FALSE(phones_by_rules(text, rules()).empty()) << text;
    } catch (const Error& error) {
      ASSERT_STRNE(error.what(), "");
    }
  }
  EXPECT_GT(readable, 500);
}

}  // namespace
}  // namespace bimodal

#include "stimuli/words/letter_to_sound.hpp"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/random.hpp"
#include "stimuli/words/dictionary.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const LetterToSound& rules() {
  static const auto shipped = LetterToSound::shipped();
  return shipped;
}

/// "HH EH L OW | W ER L D".
std::string said(std::string_view text) {
  std::string phones;
  for (const auto& word : rules().words(text)) {
    phones += (phones.empty() ? "" : " | ") + spell(word.phones);
  }
  return phones;
}

std::vector<std::string> written(std::string_view text) {
  std::vector<std::string> words;
  for (const auto& word : rules().words(text)) words.push_back(word.written);
  return words;
}

std::vector<Pause> pauses(std::string_view text) {
  std::vector<Pause> pauses;
  for (const auto& word : rules().words(text)) pauses.push_back(word.after);
  return pauses;
}

TEST(LetterToSound, SaysWhatTheOriginalProgramSays) {
  EXPECT_EQ(said("HELLO WORLD"), "HH EH L OW | W ER L D");
  EXPECT_EQ(said("stew"), "S T UW");
  EXPECT_EQ(said("boot"), "B UW T");
  EXPECT_EQ(said("beet"), "B IY T");
  EXPECT_EQ(said("to"), "T UW");
  EXPECT_EQ(said("put"), "P UH T");
  EXPECT_EQ(said("screw driver"), "S K R UW | D R AY V ER");
  EXPECT_EQ(said("Twenty Two"), "T W EH N T IY | T UW");
  EXPECT_EQ(said("Temporary Food Stew"), "T EH M P AO R EH R IY | F UH D | S T UW");
}

TEST(LetterToSound, ReadsDigitsOneByOne) {
  EXPECT_EQ(said("22"), "T UW T UW");
  EXPECT_EQ(said("0123456789"),
            "Z IH R OW W AH N T UW TH R IY F OW R F AY V S IH K S S EH V AX N EY T N AY N");
}

TEST(LetterToSound, PutsBlanksAroundPunctuation) {
  EXPECT_EQ(said("don't"), "D OW N T") << "ON ' T";
  EXPECT_EQ(said("John's"), "JH AA N Z") << "' S after a voiced consonant";
  EXPECT_EQ(said("hasn't"), "HH AE Z AX N T") << "SN before an apostrophe";
  EXPECT_EQ(said("we're"), "W IY R") << "E after an apostrophe";
  EXPECT_EQ(said("to,put."), "T UW | P UH T") << "rules for ends of words";
}

TEST(LetterToSound, KeepsWordsApartWithTheirSpellingAndPauses) {
  EXPECT_THAT(written("Don't  stop-- the screw-driver, \"now\"!"),
              ElementsAre("Don't", "stop", "the", "screw-driver", "now"));
  EXPECT_THAT(
      pauses("a b, c. d? e--f"),
      ElementsAre(
          Pause::None, Pause::Comma, Pause::Stop, Pause::Question, Pause::Dash, Pause::None));
  EXPECT_THAT(pauses(", a ,. b"), ElementsAre(Pause::Stop, Pause::None)) << "the strongest counts";
  EXPECT_THAT(written("the dogs' tail"), ElementsAre("the", "dogs", "tail"));
}

TEST(LetterToSound, HasNoWordsWithoutLettersAndDigits) {
  for (const auto* const text : {"", " ", "!?", "'", "' - '", "...", "\xFF"}) {
    EXPECT_THAT(rules().words(text), IsEmpty()) << text;
  }
}

TEST(LetterToSound, MayLeaveAWordSilent) {
  EXPECT_THAT(
      rules().words("h"),
      ElementsAre(PronouncedWord{.written = "h", .phones = {}, .source = PhoneSource::Rules}));
}

TEST(LetterToSound, TriesRulesInTheirOrderWithBacktracking) {
  ASSERT_NE(rules().rule_at(" DEGREES ", 7), nullptr);
  EXPECT_EQ(rules().rule_at(" DEGREES ", 7)->name, "S15") << "a greedy match would find none";
  EXPECT_EQ(said("degrees"), "D EH G R IY Z");
  EXPECT_EQ(rules().rule_at(" PUT ", 1)->name, "P4");
  EXPECT_EQ(rules().rule_at(" PUTS ", 1)->name, "P5");
}

/// A text in which the context stands: a random choice for each of its symbols.
std::string example_of(std::string_view ready_context, Random& random) {
  const auto one_of = [&](std::string_view letters) {
    return std::string{letters[random.below(letters.size())]};
  };
  static constexpr std::string_view kConsonants = "BCDFGHJKLMNPQRSTVWXZ";
  static constexpr std::array<std::string_view, 5> kSuffixes{"E ", "ER ", "ES ", "ED ", "ING "};
  std::string example;
  for (const char symbol : ready_context) {
    const auto repeated = 1 + random.below(2);
    switch (symbol) {
      case '#':
        for (std::size_t i = 0; i < repeated; ++i) example += one_of("AEIOUY");
        break;
      case ':':
        for (std::size_t i = 1; i < repeated; ++i) example += one_of(kConsonants);
        break;
      case '^':
        example += one_of(kConsonants);
        break;
      case '.':
        example += one_of("BDVGJLMNRWZ");
        break;
      case '+':
        example += one_of("EIY");
        break;
      case '&':
        example += one_of("SCGZXJ");
        break;
      case '@':
        example += one_of("TSRDLZNJ");
        break;
      case '%':
        example += kSuffixes.at(random.below(kSuffixes.size()));
        break;
      default:
        example += symbol;
    }
  }
  return example;
}

TEST(LetterToSound, EveryRuleDecidesSomeText) {
  Random random{7948};
  std::vector<std::string> never;
  for (const auto& rule : rules().rules()) {
    bool decides = false;
    for (int attempt = 0; attempt < 2'000 && !decides; ++attempt) {
      auto left = example_of(rule.left, random);
      std::ranges::reverse(left);
      left.insert(0, std::array<std::string_view, 3>{"", "X", "EX"}.at(random.below(3)));
      auto right = example_of(rule.right, random);
      if (random.below(2) == 0) right += "X";
      const auto text = " " + left + rule.letters + right + " ";
      const auto* const winner = rules().rule_at(text, 1 + left.size());
      decides = winner != nullptr && winner->name == rule.name;
    }
    if (!decides) never.push_back(rule.name);
  }
  EXPECT_THAT(never, IsEmpty());
}

TEST(LetterToSound, ReadsAnyTextToItsEnd) {
  static constexpr std::string_view kLetters =
      "ABEEHIINOSTUWYRDGLabcdeinst 0129''-,.? !\"%()\xC3\xA9";
  Random random{1976};
  for (int i = 0; i < 10'000; ++i) {
    std::string text;
    for (auto length = random.below(40); length > 0; --length) {
      text += kLetters[random.below(kLetters.size())];
    }
    const bool has_words = std::ranges::any_of(text, [](char letter) {
      return static_cast<unsigned char>(letter) < 0x80 && std::isalnum(letter) != 0;
    });
    ASSERT_EQ(rules().words(text).empty(), !has_words) << text;
  }
}

TEST(LetterToSound, AgreesWithTheDictionaryOnMostMonosyllables) {
  std::vector<Diagnostic> diagnostics;
  const auto list =
      read_word_list(asset("stimuli/assets/words/monosyllables-414.json"), diagnostics);
  ASSERT_THAT(diagnostics, IsEmpty());
  const auto agreeing = std::ranges::count_if(list.words, [](const Word& word) {
    auto phones = rules().words(word.spelling).at(0).phones;
    // The dictionary has no AX and no WH.
    std::ranges::replace(phones, Phone::AX, Phone::AH);
    std::ranges::replace(phones, Phone::WH, Phone::W);
    return phones == word.phones;
  });
  EXPECT_GE(agreeing, 355) << "of " << list.words.size();
}

}  // namespace
}  // namespace bimodal

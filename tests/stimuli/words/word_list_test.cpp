#include "stimuli/words/word_list.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Outcome {
  WordList list;
  std::vector<std::string> messages;  ///< without the folder
};

Outcome read(std::string_view text) {
  const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder{::testing::TempDir()};
  const auto file = folder / (std::string{"bimodal-words-"} + test->name() + ".json");
  std::ofstream{file, std::ios::binary} << text;
  std::vector<Diagnostic> diagnostics;
  Outcome outcome{read_word_list(file, diagnostics), {}};
  for (auto& diagnostic : diagnostics) {
    EXPECT_EQ(diagnostic.file, file.string());
    diagnostic.file = "words.json";
    outcome.messages.push_back(describe(diagnostic));
  }
  return outcome;
}

TEST(WordList, ReadsWordsInTheirOrder) {
  const auto [list, messages] = read(R"({"name": "two", "words": [
    {"word": "stew", "phones": ["S", "T", "UW"]},
    {"word": "ape", "phones": ["EY", "p"]}]})");
  EXPECT_THAT(messages, IsEmpty());
  EXPECT_EQ(list.name, "two");
  EXPECT_THAT(list.words,
              ElementsAre(Word{"stew", {Phone::S, Phone::T, Phone::UW}},
                          Word{"ape", {Phone::EY, Phone::P}}));
}

TEST(WordList, NamesTheLineWhereJsonEnds) {
  const auto [list, messages] = read("{\"words\": [\n  {\"word\" \"stew\"}\n]}");
  EXPECT_THAT(list.words, IsEmpty());
  EXPECT_THAT(
      messages,
      ElementsAre(AllOf(HasSubstr("words.json:2: not JSON: "), HasSubstr("comma is missing"))));
}

TEST(WordList, ReportsAllMistakesAtOnceAndKeepsWhatIsRight) {
  const auto [list, messages] = read(R"({"words": [
    {"word": "stew", "phones": ["S", "T", "QQ", 4]},
    {"word": "soup", "phones": ["S", "UW", "P"]},
    {"word": "soup", "phones": ["S", "UW", "P"]},
    {"word": "Stew", "phones": []},
    {"phones": ["S"]},
    {"word": "rest", "phones": ["rest"]},
    "stew"
  ], "wrods": 1})");
  EXPECT_THAT(list.words, ElementsAre(Word{"soup", {Phone::S, Phone::UW, Phone::P}}));
  EXPECT_THAT(
      messages,
      ElementsAre(
          AllOf(HasSubstr(":9: /wrods: warning: nothing reads \"wrods\""), HasSubstr("words")),
          HasSubstr(":2: /words/0/phones/2: \"QQ\" is not a phone; use the symbols P B M"),
          HasSubstr(":2: /words/0/phones/3: 4 is not a phone"),
          HasSubstr(":4: /words/2/word: \"soup\" stands already at /words/1; leave one"),
          HasSubstr(":5: /words/3/word: \"Stew\" has a capital letter or a space"),
          HasSubstr(":5: /words/3/phones: [] is no pronunciation"),
          HasSubstr(":6: /words/4: there is no \"word\""),
          HasSubstr(":7: /words/5/phones/0: \"rest\" is not a phone"),
          HasSubstr(":8: /words/6: \"stew\" is no word; write {\"word\": \"stew\"")));
}

TEST(WordList, WantsWords) {
  EXPECT_THAT(read("[]").messages, ElementsAre(HasSubstr(":1: a word list must be an object")));
  EXPECT_THAT(read("{}").messages, ElementsAre(HasSubstr(":1: there is no \"words\"")));
  EXPECT_THAT(read("{\n\"words\": []}").messages,
              ElementsAre(HasSubstr(":2: /words: there are no words")));
  EXPECT_THAT(read(R"({"name": 3, "words": 7})").messages,
              ElementsAre(HasSubstr("/name: 3 is no text"), HasSubstr("/words: 7 is no array")));
}

TEST(WordList, ReportsAFileThatIsNotThere) {
  std::vector<Diagnostic> diagnostics;
  EXPECT_THAT(read_word_list("no/such/words.json", diagnostics).words, IsEmpty());
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_THAT(describe(diagnostics[0]), HasSubstr("cannot read 'no/such/words.json'"));
}

TEST(WordList, ReadsAmbiguousSounds) {
  const auto [list, messages] = read(R"({"words": [
    {"word": "bw-7", "phones": ["B~W:7/8", "AA"]},
    {"word": "ba", "phones": ["B", "AA"], "seen": "bw-7"},
    {"word": "wa", "phones": ["W", "AA"], "seen": {"word": "bw-1", "phones": ["b~w:1/8", "AA"]}}]})");
  EXPECT_THAT(messages, IsEmpty());
  ASSERT_EQ(list.words.size(), 3U);
  const std::vector<Segment> bw{{Phone::B, Phone::W, 7, 8}, Phone::AA};
  EXPECT_EQ(list.words[0].phones, (Pronunciation{Phone::W, Phone::AA}));
  EXPECT_EQ(list.words[0].articulation, bw);
  EXPECT_TRUE(list.words[1].articulation.empty());
  ASSERT_TRUE(list.words[1].seen);
  EXPECT_EQ(list.words[1].seen->articulation, bw);
  ASSERT_TRUE(list.words[2].seen);
  EXPECT_EQ(list.words[2].seen->spelling, "bw-1");
  EXPECT_EQ(list.words[2].seen->phones, (Pronunciation{Phone::B, Phone::AA}));
}

TEST(WordList, SaysWhatIsWrongWithAmbiguousAndSeenWords) {
  const auto messages = read(R"({"words": [
    {"word": "bw", "phones": ["B~W:9/8", "AA"]},
    {"word": "br", "phones": ["B~rest:1/8", "AA"]},
    {"word": "ba", "phones": ["B", "AA"], "seen": {"word": "ba", "phones": ["W"]}},
    {"word": "da", "phones": ["D", "AA"], "seen": {"word": "ga", "phones": ["Q"], "as": 1}}]})")
                            .messages;
  EXPECT_THAT(messages,
              ElementsAre(HasSubstr("/words/0/phones/0: \"B~W:9/8\" goes beyond its end"),
                          HasSubstr("/words/1/phones/0: \"B~rest:1/8\" is not a phone"),
                          HasSubstr("/words/2/seen/word: \"ba\" is the name of what is heard too"),
                          HasSubstr("/words/3/seen/as"),
                          HasSubstr("/words/3/seen/phones/0: \"Q\" is not a phone")));
}

}  // namespace
}  // namespace bimodal

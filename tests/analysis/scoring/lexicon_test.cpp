#include "analysis/scoring/lexicon.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "tests/analysis/examples.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/fault_of.hpp"

namespace bimodal::analysis {
namespace {

using examples::phones;
using examples::trial;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string fault_in(std::string_view text) {
  return fault_of([&] { return parse_lexicon(text, "l.csv"); });
}

TEST(Lexicon, ReadsArpabetAndIpa) {
  const auto lexicon = parse_lexicon(
      "\xef\xbb\xbfgroup,Spelling,Pronunciation\n1,Stew,S T UW1\n2,two,tu\n3,can't,K AE N T\n",
      "l.csv");
  EXPECT_THAT(lexicon.pronunciations("stew"), ElementsAre(phones("S T UW")));
  EXPECT_THAT(lexicon.pronunciations("two"), ElementsAre(phones("T UW")));
  EXPECT_THAT(lexicon.pronunciations("can't"), ElementsAre(phones("K AE N T")));
  EXPECT_THAT(lexicon.pronunciations("red"), IsEmpty());
}

TEST(Lexicon, KeepsSeveralPronunciationsInTheirOrder) {
  const auto lexicon =
      parse_lexicon("word,phonemes\nread,R IY D\nbow,B AW\nread,R EH D\n", "l.csv");
  EXPECT_THAT(lexicon.pronunciations("read"), ElementsAre(phones("R IY D"), phones("R EH D")));
  EXPECT_TRUE(
      parse_lexicon("word,phones\nread,R EH D\nred,R EH D\n", "l").homophones("read", "red"));
}

TEST(Lexicon, TakesNaForAWord) {
  const auto lexicon = parse_lexicon("word,phonemes\nNA,N AA\n", "l.csv");
  EXPECT_THAT(lexicon.pronunciations("na"), ElementsAre(phones("N AA")));
}

TEST(Lexicon, RefusesWhatItCannotReadAndSaysWhere) {
  EXPECT_THAT(fault_in(""), HasSubstr("the file is empty"));
  EXPECT_THAT(fault_in("word,meaning\n"), HasSubstr("l.csv:1: there is no column \"phonemes\""));
  EXPECT_THAT(fault_in("phonemes\n"), HasSubstr("l.csv:1: there is no column \"word\""));
  EXPECT_THAT(fault_in("word,phonemes\n"), HasSubstr("there are no words"));
  EXPECT_THAT(fault_in("word,phonemes\nstew,S T UW\ntwo\n"), HasSubstr("l.csv:3: 1 fields"));
  EXPECT_THAT(fault_in("word,phonemes\n?!,S\n"), HasSubstr("l.csv:2: the word has no letters"));
  EXPECT_THAT(fault_in("word,phonemes\nstew,\n"), HasSubstr("l.csv:2: \"stew\" has no phonemes"));
  EXPECT_THAT(fault_in("word,phonemes\nstew,S T OO\n"),
              HasSubstr("l.csv:2: \"S T OO\" is neither ARPAbet with blanks between nor IPA"));
  EXPECT_THAT(fault_in("word,phonemes\n\xff,S\n"), HasSubstr("not UTF-8"));
}

TEST(Lexicon, IsReadOrRefusedWhateverTheBytes) {
  Damage damage{20};
  const std::string good = "word,phonemes\nstew,S T UW1\nread,R IY D\nread,R EH D\ntwo,tu\n";
  for (int round = 0; round < 20'000; ++round) {
    try {
      EXPECT_FALSE(parse_lexicon(damage(good), "l.csv").spellings().empty());
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("l.csv"));
    }
  }
}

TEST(PronounceStimuli, LooksUpWhatTrialsDoNotSay) {
  const auto lexicon =
      parse_lexicon("word,phonemes\nread,R IY D\nread,R EH D\nstew,S T UW\n", "l.csv");
  std::vector<Trial> trials{trial("read", "R EH D", ""),
                            trial("Read", "", ""),
                            trial("stew", "", ""),
                            trial("two", "", "")};
  const auto counts = pronounce_stimuli(trials, lexicon);
  EXPECT_EQ(counts.known, 1);
  EXPECT_EQ(counts.found, 2);
  EXPECT_EQ(counts.ambiguous, 1);
  EXPECT_EQ(counts.lacking, 1);
  EXPECT_EQ(trials[0].phones, phones("R EH D"));
  EXPECT_EQ(trials[1].phones, phones("R IY D"));
  EXPECT_EQ(trials[2].phones, phones("S T UW"));
  EXPECT_THAT(trials[3].phones, IsEmpty());
}

}  // namespace
}  // namespace bimodal::analysis

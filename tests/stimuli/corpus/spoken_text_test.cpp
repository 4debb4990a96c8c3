#include "stimuli/corpus/spoken_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using testing::ThrowsMessage;

TEST(SpokenText, IsTakenApartIntoLowerCaseWords) {
  EXPECT_THAT(words_of_text("\xEF\xBB\xBF\"Don't\", said  Ann-Marie;\r\nGO!", "a.txt"),
              ElementsAre("don't", "said", "ann-marie", "go"));
  EXPECT_THAT(words_of_text("'tis the boys' caf\xC3\xA9 - no", "a.txt"),
              ElementsAre("tis", "the", "boys", "caf\xC3\xA9", "no"));
}

TEST(SpokenText, WithoutWordsIsRefused) {
  for (const char* const text : {"", " \n\t ", "... -- ?"}) {
    EXPECT_THAT([&] { static_cast<void>(words_of_text(text, "said.txt")); },
                ThrowsMessage<Error>(HasSubstr("'said.txt': there are no words")));
  }
}

TEST(SpokenText, ThatIsNoTextIsRefused) {
  EXPECT_THAT([] { static_cast<void>(words_of_text("bin \xFF lue", "a")); },
              ThrowsMessage<Error>(HasSubstr("UTF-8")));
  EXPECT_THAT(
      [] {
        static_cast<void>(words_of_text(std::string_view{"bin\0blue", 8}, "a"));
      },
      ThrowsMessage<Error>(HasSubstr("control characters")));
  EXPECT_THAT([] { static_cast<void>(words_of_text(std::string(200, 'x'), "a")); },
              ThrowsMessage<Error>(HasSubstr("200 letters")));
}

TEST(SpokenText, OfSeveralRecordingsGoesByTheirNames) {
  EXPECT_THAT(parse_texts("# said\n\none.wav\tBin blue\r\nclips/two.mpg\tset white\n", "t.tsv"),
              ElementsAre(Pair("one", ElementsAre("bin", "blue")),
                          Pair("two", ElementsAre("set", "white"))));
}

TEST(SpokenText, OfSeveralRecordingsNamesTheFaultyLine) {
  EXPECT_THAT([] { static_cast<void>(parse_texts("one\tbin\ntwo set", "t.tsv")); },
              ThrowsMessage<Error>(HasSubstr("'t.tsv:2': there is no tab")));
  EXPECT_THAT([] { static_cast<void>(parse_texts("one\tbin\none\tset", "t.tsv")); },
              ThrowsMessage<Error>(HasSubstr("'t.tsv:2': the recording 'one' stands twice")));
  EXPECT_THAT([] { static_cast<void>(parse_texts("one\t ,", "t.tsv")); },
              ThrowsMessage<Error>(HasSubstr("t.tsv:1")));
}

TEST(SpokenText, OfAnyBytesIsReadOrRefused) {
  Random random{5};
  const std::string seed = "one.wav\tBin blue at f\n# x\ntwo\tdon't - caf\xC3\xA9\r\n";
  for (int trial = 0; trial < 20'000; ++trial) {
    auto text = seed;
    for (std::uint64_t change = random.below(8); change-- > 0;) {
      const auto at = random.below(text.size());
      const char byte = static_cast<char>(random.below(256));
      switch (random.below(3)) {
        case 0:
          text[at] = byte;
          break;
        case 1:
          text.insert(text.begin() + static_cast<std::ptrdiff_t>(at), byte);
          break;
        default:
          text.erase(at, random.below(5));
          break;
      }
      if (text.empty()) text.push_back('x');
    }
    try {
      for (const auto& [name, words] : parse_texts(text, "fuzz")) {
        EXPECT_FALSE(words.empty()) << name;
      }
    } catch (const Error&) {
    }
  }
}

TEST(SpokenText, IsPronouncedAsTheListSaysAndElseAsTheDictionary) {
  const std::vector<Word> list{{"bin", {Phone::B, Phone::IY, Phone::N}}};
  Pronouncer pronouncer{list};
  EXPECT_TRUE(pronouncer.is_listed("bin"));
  EXPECT_FALSE(pronouncer.is_listed("blue"));
  EXPECT_THAT(pronouncer.pronounce("bin").pronunciations,
              ElementsAre(Pronunciation{Phone::B, Phone::IY, Phone::N}));
  try {
    EXPECT_THAT(pronouncer.pronounce("blue").pronunciations,
                ElementsAre(Pronunciation{Phone::B, Phone::L, Phone::UW}));
  } catch (const Error& error) {
    GTEST_SKIP() << error.what();
  }
  EXPECT_THAT([&] { static_cast<void>(pronouncer.pronounce("qzrt")); },
              ThrowsMessage<Error>(HasSubstr("nobody knows how \"qzrt\" is said")));
}

}  // namespace
}  // namespace bimodal

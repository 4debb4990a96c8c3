// What the face does: its account, its inventory, and sounds between two others.
#include <gmock/gmock.h>

#include "tests/protocols/reading/reading.hpp"

namespace bimodal::protocols {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST_F(Reading, AccountAndInventoryOfTheFaceAreRead) {
  std::string text{kGood};
  const std::string plain = R"("visual": {"talker": "face"})";
  EXPECT_EQ(read(text).protocol.conditions.at(1).articulating.account, Account::Dominance);
  text.replace(
      text.find(plain),
      plain.size(),
      R"("visual": {"talker": "face", "coarticulation": "look-ahead", "segments": "mine.json"})");
  EXPECT_THAT(messages(text),
              ElementsAre(HasSubstr("/conditions/1/visual/segments: there is neither")));
  files_.write("mine.json", "{}");
  const auto protocol = read(text);
  EXPECT_THAT(protocol.diagnostics, IsEmpty());
  const auto& articulating = protocol.protocol.conditions.at(1).articulating;
  EXPECT_EQ(articulating.account, Account::LookAhead);
  EXPECT_EQ(articulating.segments, (files_.folder() / "mine.json").string());
}

TEST_F(Reading, RecordingsHaveNoAccountUnlessTheFaceTakesTheirPlace) {
  const std::string plain = R"("visual": {"talker": "face"})";
  EXPECT_THAT(messages(plain, R"("visual": {"talker": "corpus:mine", "coarticulation": "hybrid"})"),
              Contains(HasSubstr("/conditions/1/visual/coarticulation: recordings articulate")));
  EXPECT_THAT(messages(plain,
                       R"("visual": {"talker": "corpus:mine", "otherwise": "face",
                                     "coarticulation": "hybrid"})"),
              ElementsAre(HasSubstr("takes its place")));
}

TEST_F(Reading, AVoiceSaysTheNearerOfAmbiguousSounds) {
  const auto heard =
      messages(R"(["cat", "Dog"])", R"(["cat", {"word": "bw", "phones": ["B~W:5/8", "AA"]}])");
  EXPECT_THAT(heard, ElementsAre(HasSubstr("bw as W AA")));
  std::string text{kGood};
  text.replace(text.find(R"(["cat", "Dog"])"),
               14,
               R"([{"word": "bw", "phones": ["B~W:5/8", "AA"]}, "cat"])");
  text.replace(text.find(R"("snr_db": -8)"), 12, R"("snr_db": -8, "visual": {"talker": "face"})");
  EXPECT_THAT(messages(text), ElementsAre(HasSubstr("bw as W AA")));
  // A sound of its own that is heard with it needs no warning, nor do the ends.
  const std::string between = R"({"word": "bw", "phones": ["B~W:5/8", "AA"]})";
  auto dubbed = text;
  dubbed.replace(dubbed.find(between),
                 between.size(),
                 R"({"word": "wa", "phones": ["W", "AA"], "seen": )" + between + "}");
  EXPECT_THAT(messages(dubbed), IsEmpty());
  const auto words = read(dubbed).words.words;
  ASSERT_TRUE(words.at(0).seen);
  EXPECT_EQ(words[0].seen->articulation.at(0), (Segment{Phone::B, Phone::W, 5, 8}));
  auto end = text;
  end.replace(end.find("5/8"), 3, "8/8");
  EXPECT_THAT(messages(end), IsEmpty());
}

}  // namespace
}  // namespace bimodal::protocols

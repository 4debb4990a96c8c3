// What of the synthetic face is seen, and how it holds itself.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/protocols/reading/reading.hpp"

namespace bimodal::protocols {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

class ReadingFace : public Reading {
 protected:
  /// The good protocol, with these keys of its own and these of its second condition's face.
  static std::string text(std::string_view whole, std::string_view own) {
    std::string text{kGood};
    const std::string plain = R"({"talker": "face"})";
    text.replace(text.find(plain), plain.size(), fmt::format(R"({{"talker": "face"{}}})", own));
    return text.insert(1, std::string{whole});
  }

  Face face(std::string_view whole, std::string_view own = "") const {
    const auto read = this->read(text(whole, own));
    EXPECT_THAT(read.diagnostics, IsEmpty());
    return read.protocol.conditions.at(1).face;
  }

  std::vector<std::string> complaints(std::string_view own) const {
    return messages(text("", fmt::format(R"(, "face": {})", own)));
  }
};

TEST_F(ReadingFace, IsWholeAndFromTheFrontUnlessItIsSaid) {
  EXPECT_EQ(face(""), Face{});
  EXPECT_EQ(Face{}.view, "front");
  EXPECT_EQ(Face{}.points, "none");
}

TEST_F(ReadingFace, OfAConditionIsThatOfTheProtocolKeyByKey) {
  const auto* const whole = R"("face": {"view": "mouth", "hide": ["hair"], "transparency": 0.25,
      "expression": {"smile": 0.5, "fear": 0.5}, "controls": {"gaze_x": 3}},)";
  const auto usual = face(whole);
  EXPECT_EQ(usual.view, "mouth");
  EXPECT_THAT(usual.expression, UnorderedElementsAre(Pair("smile", 0.5), Pair("fear", 0.5)));
  const auto own = face(whole, R"(, "face": {"hide": ["tongue"], "expression": {"anger": 1}})");
  EXPECT_EQ(own.view, "mouth");
  EXPECT_EQ(own.transparency, 0.25);
  EXPECT_THAT(own.hide, ElementsAre("tongue"));
  EXPECT_THAT(own.expression, ElementsAre(Pair("anger", 1.0)));
  EXPECT_THAT(own.controls, ElementsAre(Pair("gaze_x", 3.0)));
  EXPECT_THAT(face(whole, R"(, "face": {"expression": {}})").expression, IsEmpty());
}

TEST_F(ReadingFace, ThatAsksForWhatIsUnknownIsToldWhatIsNear) {
  EXPECT_THAT(complaints(R"({"show": ["lips", "tonge"]})"),
              ElementsAre(AllOf(HasSubstr("test.json:8: /conditions/1/visual/face/show/1: "),
                                HasSubstr("did you mean \"tongue\"?"))));
  EXPECT_THAT(complaints(R"({"expression": {"smlie": 1}})"),
              ElementsAre(HasSubstr("did you mean \"smile\"?")));
  EXPECT_THAT(complaints(R"({"material": "cley"})"),
              ElementsAre(AllOf(HasSubstr("/face/material: there are no materials \"cley\""),
                                HasSubstr("did you mean \"clay\"?"))));
  EXPECT_THAT(complaints(R"({"view": "sides"})"), ElementsAre(HasSubstr("did you mean \"side\"?")));
  EXPECT_THAT(complaints(R"({"transparancy": 1})"),
              ElementsAre(HasSubstr("did you mean \"transparency\"?")));
}

TEST_F(ReadingFace, IsNeverClampedInSilence) {
  EXPECT_THAT(complaints(R"({"controls": {"gaze_x": 31}})"),
              ElementsAre(HasSubstr("31 is outside -30 to 30")));
  EXPECT_THAT(complaints(R"({"expression": {"smile": 1.5}})"),
              ElementsAre(HasSubstr("1.5 is outside 0 to 1")));
  EXPECT_THAT(
      complaints(R"({"expression": {"surprise": 1}, "controls": {"brow_raise": 3}})"),
      ElementsAre(AllOf(HasSubstr("/face/expression: "), HasSubstr("\"brow_raise\" to 10 mm"))));
  EXPECT_THAT(complaints(R"({"expression": {"surprise": 1}, "controls": {"brow_raise": 2}})"),
              IsEmpty());
}

TEST_F(ReadingFace, LeavesToSpeechWhatSpeechMoves) {
  EXPECT_THAT(complaints(R"({"controls": {"jaw": 3, "gaze_z": 1}})"),
              UnorderedElementsAre(
                  AllOf(HasSubstr("/controls/jaw: speech moves \"jaw\""), HasSubstr("head_yaw")),
                  HasSubstr("did you mean \"gaze_x\"?")));
}

TEST_F(ReadingFace, MustLeaveSomethingToBeSeen) {
  EXPECT_THAT(complaints(R"({"show": ["teeth"], "hide": ["upper_teeth", "lower_teeth"]})"),
              ElementsAre(HasSubstr("/face/hide: nothing of the face is left")));
  EXPECT_THAT(complaints(R"({"show": ["teeth"], "hide": ["upper_teeth"]})"), IsEmpty());
}

TEST_F(ReadingFace, MayHaveMaterialsOfItsOwnBesideTheProtocol) {
  EXPECT_THAT(complaints(R"({"material": "mine.json"})"),
              ElementsAre(HasSubstr("/face/material: cannot read the materials 'mine.json'")));
  files_.write("mine.json", "{}");
  EXPECT_EQ(face("", R"(, "face": {"material": "mine.json"})").material,
            (files_.folder() / "mine.json").string());
}

TEST_F(ReadingFace, IsNotThatOfARecording) {
  EXPECT_THAT(messages(R"({"talker": "face"})", R"({"talker": "corpus:x", "face": {}})"),
              ::testing::Contains(HasSubstr("/visual/face: recordings articulate and look")));
}

TEST_F(ReadingFace, ThatNobodySeesIsAWarning) {
  auto unseen = text(R"("face": {"view": "side"},)", "");
  const std::string seen = R"("visual": {"talker": "face"})";
  unseen.replace(unseen.find(seen), seen.size(), R"("auditory": {"talker": "festival:kal"})");
  EXPECT_THAT(messages(unseen),
              ElementsAre(HasSubstr("/face: warning: no condition shows the synthetic face")));
}

}  // namespace
}  // namespace bimodal::protocols

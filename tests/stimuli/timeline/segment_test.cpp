#include "stimuli/timeline/segment.hpp"

#include <gtest/gtest.h>

namespace bimodal {
namespace {

using enum Phone;

Segment parsed(std::string_view text) {
  const auto result = parse_segment(text);
  const auto* segment = std::get_if<Segment>(&result);
  EXPECT_NE(segment, nullptr) << text << ": " << std::get<SegmentFault>(result).finding;
  return segment == nullptr ? Segment{} : *segment;
}

std::string fault(std::string_view text) {
  const auto result = parse_segment(text);
  const auto* fault = std::get_if<SegmentFault>(&result);
  return fault == nullptr ? "none" : fault->finding;
}

TEST(Segment, IsAPhoneOrAStepFromOneToAnother) {
  EXPECT_EQ(parsed("uw1"), Segment{UW});
  EXPECT_EQ(parsed("b~w:3/8"), (Segment{B, W, 3, 8}));
  EXPECT_DOUBLE_EQ(parsed("b~w:3/8").share(), 0.375);
  EXPECT_EQ(parsed("rest~AA:0/1"), (Segment{Rest, AA, 0, 1}));
}

TEST(Segment, IsWrittenAsItIsRead) {
  for (const auto* const text : {"S", "rest", "B~W:3/8", "AY~OY:1000/1000"}) {
    EXPECT_EQ(symbol(parsed(text)), text);
  }
}

TEST(Segment, SaysWhatIsNoSegment) {
  EXPECT_EQ(fault("Q"), "\"Q\" is not a phone");
  EXPECT_EQ(fault("b~q:3/8"), "\"q\" is not a phone");
  EXPECT_EQ(fault("~w:3/8"), "\"\" is not a phone");
  for (const auto* const text :
       {"b~w", "b~w:3", "b~w:-1/8", "b~w:1/0", "b~w:1/1001", "b~w:1.5/8", "b~w:/", "b~w/8:3"}) {
    EXPECT_NE(fault(text).find("names no step"), std::string::npos) << text;
  }
}

TEST(Segment, IsNotAmbiguousBetweenAPhoneAndItself) {
  EXPECT_FALSE(parsed("b~b:3/8").is_ambiguous());
  EXPECT_EQ(symbol(parsed("b~b:3/8")), "B");
}

TEST(FaceSegments, TakeADiphthongInHalvesOnBothSides) {
  EXPECT_EQ(face_segments(Segment{AY}), (std::vector<Segment>{AA, IH}));
  EXPECT_EQ(face_segments(Segment{AY, OY, 1, 4}), (std::vector<Segment>{{AA, AO, 1, 4}, IH}));
  EXPECT_EQ(face_segments(Segment{IY, AY, 0, 4}), (std::vector<Segment>{IY}));
  EXPECT_EQ(face_segments(Segment{IY, AY, 4, 4}), (std::vector<Segment>{AA, IH}));
  EXPECT_EQ(face_segments(Segment{IY, AY, 1, 4}),
            (std::vector<Segment>{{IY, AA, 1, 4}, {IY, IH, 1, 4}}));
}

TEST(Segment, SaysWhichStepIsNone) {
  EXPECT_EQ(fault("IY~UW:7/6"), "\"IY~UW:7/6\" goes beyond its end: 7 of 6 steps");
}

TEST(Segment, IsHeardAsTheNearerPhoneHalfwayAsTheFirst) {
  EXPECT_EQ(parsed("b~w:3/8").nearer(), B);
  EXPECT_EQ(parsed("b~w:4/8").nearer(), B);
  EXPECT_EQ(parsed("b~w:5/8").nearer(), W);
  EXPECT_EQ(parsed("b~w:500/999").nearer(), W);
  EXPECT_EQ(parsed("s").nearer(), S);
}

TEST(SpelledSegments, HaveAnArticulationOnlyWhereSomethingIsAmbiguous) {
  const std::vector<Segment> plain{B, AA};
  EXPECT_EQ(spelled(plain), (SpelledSegments{{B, AA}, {}}));
  const std::vector<Segment> ambiguous{{B, W, 7, 8}, AA};
  EXPECT_EQ(spelled(ambiguous), (SpelledSegments{{W, AA}, ambiguous}));
}

TEST(SoundOfAWord, IsNeverRest) {
  for (const auto* const text : {"rest", "rest~b:1/2", "b~rest:0/2", "q", ""}) {
    EXPECT_TRUE(std::holds_alternative<SegmentFault>(parse_sound(text))) << text;
  }
  EXPECT_TRUE(std::holds_alternative<Segment>(parse_sound("b~w:1/2")));
}

}  // namespace
}  // namespace bimodal

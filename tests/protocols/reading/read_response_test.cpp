// What a protocol says about answers and timing, and what is said where it does not fit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/protocols/reading/reading.hpp"

namespace bimodal::protocols {
namespace {

using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ReadingResponses : public Reading {
 protected:
  Response response(std::string_view written) const {
    return protocol_with("\"response\": " + std::string{written}).response;
  }
};

TEST_F(ReadingResponses, AreTypedAndCountFromTheEndByDefault) {
  const auto read = response("{}");
  EXPECT_EQ(read.kind, ResponseKind::Typed);
  EXPECT_EQ(read.rt_from, RtFrom::End);
  EXPECT_EQ(protocol_with("\"timing\": {}").timing, Timing{});
}

TEST_F(ReadingResponses, AreReadWithEveryKeyOfAChoice) {
  const auto read = response(R"({
    "kind": "choice", "prompt": "?", "time_limit_s": 1.5, "pointer": true, "confirm": true,
    "from": "onset",
    "options": [{"label": "ba", "key": "B", "button": 2}, {"label": "wa", "button": 1}]})");
  EXPECT_EQ(read.kind, ResponseKind::Choice);
  EXPECT_EQ(read.time_limit, Duration{1'500ms});
  EXPECT_TRUE(read.pointer && read.confirm);
  EXPECT_EQ(read.from, AnswersFrom::Onset);
  EXPECT_THAT(read.options, ElementsAre(Option{"ba", "B", 2}, Option{"wa", "", 1}));
}

TEST_F(ReadingResponses, NumberTheKeysOfOptionsWhereNoneIsGiven) {
  std::string options;
  for (int i = 1; i <= 11; ++i)
    options += std::string{i > 1 ? ", " : ""} + R"({"label": "o)" + std::to_string(i) + "\"}";
  const auto read =
      response(R"({"kind": "choice", "pointer": true, "options": [)" + options + "]}");
  ASSERT_EQ(read.options.size(), 11U);
  EXPECT_EQ(read.options[0].key, "1");
  EXPECT_EQ(read.options[8].key, "9");
  EXPECT_EQ(read.options[9].key, "");
}

TEST_F(ReadingResponses, TellOfEveryMistakeAtOnce) {
  EXPECT_THAT(
      with(R"("response": {"kind": "choice", "longest": 3, "options": [
        {"label": "ba", "key": "b"},
        {"label": "wa", "key": "B", "button": 3},
        {"label": "ba", "button": 3},
        {"label": "da"}]})"),
      ElementsAre(
          AllOf(HasSubstr("/response/longest"), HasSubstr("only answers of kind \"typed\"")),
          AllOf(HasSubstr("/response/options/1/key"), HasSubstr("option 1 has the same key")),
          AllOf(HasSubstr("/response/options/2/label"), HasSubstr("give every option a label")),
          AllOf(HasSubstr("/response/options/2/button"), HasSubstr("option 2")),
          AllOf(HasSubstr("/response/options/3"), HasSubstr("nothing chooses \"da\""))));
}

TEST_F(ReadingResponses, WarnOfLabelsThatOnlyCapitalsTellApart) {
  EXPECT_THAT(with(R"("response": {"kind": "choice", "options": [
        {"label": "ba", "key": "b"}, {"label": "da", "key": "d"}, {"label": "BA", "key": "c"}]})"),
              ElementsAre(AllOf(HasSubstr("/response/options/2/label: warning: only capitals"),
                                HasSubstr("\"BA\" from \"ba\""))));
}

TEST_F(ReadingResponses, WarnOfWordsThatAreNoLabelWhereOthersAre) {
  const auto of_choice = [&](const std::string& options) {
    return with(R"("response": {"kind": "choice", "options": [)" + options + "]}");
  };
  const std::string spelled = "dog";
  EXPECT_THAT(of_choice(R"({"label": ")" + spelled + R"("}, {"label": "never"})"),
              ElementsAre(AllOf(HasSubstr("/response/options: warning:"),
                                HasSubstr("are no option's label: no answer to them is right"))));
  EXPECT_THAT(of_choice(R"({"label": "sure"}, {"label": "unsure"})"), IsEmpty());
}

TEST_F(ReadingResponses, NeedOptionsForAChoice) {
  EXPECT_THAT(with(R"("response": {"kind": "choice"})"), ElementsAre(HasSubstr("options")));
  EXPECT_THAT(with(R"("response": {"pointer": true})"),
              ElementsAre(AllOf(HasSubstr("/response/pointer"), HasSubstr("kind \"choice\""))));
}

TEST_F(ReadingResponses, CountOnlyFromWhatEveryConditionHas) {
  EXPECT_THAT(with(R"("response": {"rt_from": "sound_onset"})"),
              ElementsAre(AllOf(HasSubstr("/response/rt_from"),
                                HasSubstr("the condition \"v\" has no sound"),
                                HasSubstr("\"end\""))));
  EXPECT_THAT(with(R"("response": {"rt_from": "visual_onset"})"),
              ElementsAre(HasSubstr("the condition \"a\" has no picture")));
}

TEST_F(ReadingResponses, WarnOfShortTimeOnlyWhereAWordIsToBeTyped) {
  EXPECT_THAT(with(R"("response": {"time_limit_s": 1})"), ElementsAre(HasSubstr("type a word")));
  EXPECT_THAT(with(R"("response": {"kind": "choice", "time_limit_s": 1,
                                   "options": [{"label": "a"}, {"label": "b"}]})"),
              IsEmpty());
}

TEST_F(ReadingResponses, ReadTheRulesOfTiming) {
  const auto read = protocol_with(R"("timing": {"visual_line": "mouth", "flagged": "repeat",
                                                "most_repeats": 5, "offset_tolerance_ms": 2.5})");
  EXPECT_EQ(read.timing,
            (Timing{.visual_line = VisualLine::Mouth,
                    .flagged = Flagged::Repeat,
                    .most_repeats = 5,
                    .offset_tolerance = 2'500us}));
}

TEST_F(ReadingResponses, TellOfEveryMistakeInTheRulesOfTiming) {
  EXPECT_THAT(with(R"("timing": {"visual_line": "lips", "flagged": "drop", "most_repeats": 0,
                                 "offset_tolerance_ms": 0.1, "late": 1})"),
              testing::SizeIs(5));
}

}  // namespace
}  // namespace bimodal::protocols

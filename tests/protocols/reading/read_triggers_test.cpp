// What a protocol says about channels and triggers, and what is said where it does not fit.
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

class ReadingTriggers : public Reading {
 protected:
  Triggers triggers(std::string_view written) const {
    return protocol_with("\"triggers\": " + std::string{written}).triggers;
  }
};

TEST_F(ReadingTriggers, NothingIsToldUnlessItIsAskedFor) {
  const auto none = triggers("{}");
  EXPECT_FALSE(none.photodiode || none.click || none.serial || none.socket);
  EXPECT_THAT(protocol_with("\"sound\": {}").sound.channels, IsEmpty());
}

TEST_F(ReadingTriggers, ReadsEveryKey) {
  const auto read = triggers(R"({
    "photodiode": {"corner": "lower-right", "size_px": 41, "polarity": "black-on-white",
                   "length_ms": 50},
    "click": {"channel": 4, "length_ms": 0.5, "amplitude": 0.8},
    "serial": {"port": "/dev/ttyUSB0", "baud": 9600, "reset_after_ms": 8,
               "codes": {"trial_start": 9, "auditory_zero": 255}},
    "socket": {"path": "t.socket"}})");
  ASSERT_TRUE(read.photodiode && read.click && read.serial && read.socket);
  EXPECT_EQ(read.photodiode->corner, Corner::LowerRight);
  EXPECT_EQ(read.photodiode->size, 41);
  EXPECT_EQ(read.photodiode->polarity, Polarity::BlackOnWhite);
  EXPECT_EQ(read.photodiode->length, Duration{50ms});
  EXPECT_EQ(read.click->channel, 4);
  EXPECT_EQ(read.click->length, Duration{500us});
  EXPECT_EQ(read.click->amplitude, 0.8);
  EXPECT_EQ(read.serial->port, "/dev/ttyUSB0");
  EXPECT_EQ(read.serial->baud, 9600);
  EXPECT_EQ(read.serial->reset_after, Duration{8ms});
  EXPECT_THAT(read.serial->codes, ElementsAre(9, std::nullopt, 255, std::nullopt, std::nullopt));
  EXPECT_EQ(read.socket->path, "t.socket");
  EXPECT_THAT(protocol_with(R"("sound": {"channels": [3, 1]})").sound.channels, ElementsAre(3, 1));
}

TEST_F(ReadingTriggers, TellsOfEveryMistakeAtOnce) {
  EXPECT_THAT(with(R"("sound": {"channels": [0, 1.5]}, "triggers": {
           "photodiode": {"corner": "left"},
           "click": {"amplitude": 2},
           "serial": {"port": "/dev/ttyUSB0", "codes": {"visual_zero": 300}, "reset_ms": 8},
           "sockets": {}})"),
              ElementsAre(HasSubstr("/sound/channels/0: 0 is"),
                          HasSubstr("/sound/channels/1: 1.5 is not a whole number"),
                          HasSubstr("/triggers/photodiode/corner: \"left\""),
                          HasSubstr("/triggers/click: the key \"channel\" is missing"),
                          HasSubstr("/triggers/click/amplitude: 2 is"),
                          HasSubstr("/triggers/serial/codes/visual_zero: 300 is"),
                          HasSubstr("/triggers/serial/reset_ms: the key \"reset_ms\" is not known"),
                          HasSubstr("did you mean \"socket\"?")));
}

TEST_F(ReadingTriggers, ClickMustHaveAChannelOfItsOwn) {
  const auto heard = AllOf(HasSubstr("/triggers/click/channel: the stimulus is played on channel"),
                           HasSubstr("set /sound/channels"));
  EXPECT_THAT(with(R"("triggers": {"click": {"channel": 2}})"), ElementsAre(heard));
  EXPECT_THAT(with(R"("sound": {"channels": [3]}, "triggers": {"click": {"channel": 3}})"),
              ElementsAre(heard));
  EXPECT_THAT(with(R"("sound": {"channels": [1]}, "triggers": {"click": {"channel": 2}})"),
              IsEmpty());
}

TEST_F(ReadingTriggers, ClickWhereNothingIsHeardIsWarnedOf) {
  EXPECT_THAT(messages(R"("auditory": {"talker": "festival:slt"}, "snr_db": -8},)",
                       R"("visual": {"talker": "face"}},)"),
              IsEmpty());
  std::string silent{kGood};
  const std::string_view heard = R"("auditory": {"talker": "festival:slt"}, "snr_db": -8)";
  silent.replace(silent.find(heard), heard.size(), R"("visual": {"talker": "face"})");
  silent.insert(1, R"("triggers": {"click": {"channel": 3}}, )");
  EXPECT_THAT(messages(silent), ElementsAre(HasSubstr("there is never a click")));
}

TEST_F(ReadingTriggers, EventsWithTheSameCodeAreWarnedOf) {
  const auto serial = [](std::string_view codes) {
    return R"("triggers": {"serial": {"port": "p", "codes": )" + std::string{codes} + "}}";
  };
  EXPECT_THAT(with(serial(R"({"trial_start": 1, "visual_zero": 2, "response": 1})")),
              ElementsAre(AllOf(HasSubstr("/triggers/serial/codes/response: warning: trial_start"),
                                HasSubstr("has the code 1 too"))));
  EXPECT_THAT(with(serial(R"({"visual_zero": 2, "response": 1})")), IsEmpty());
}

TEST_F(ReadingTriggers, PatchMustLieWithinTheWindow) {
  EXPECT_THAT(with(R"("triggers": {"photodiode": {"size_px": 1100}})"),
              ElementsAre(HasSubstr("is larger than the window, 1280 x 1024")));
  EXPECT_THAT(with(R"("triggers": {"photodiode": {"centre": [0.99, 0.5]}})"),
              ElementsAre(HasSubstr("reaches beyond the window")));
  EXPECT_THAT(with(R"("triggers": {"photodiode": {"centre": [0.97, 0.5]}})"), IsEmpty());
}

TEST(Patch, LiesInItsCornerOrAroundItsMiddle) {
  const auto corner_of = [](Corner corner) {
    const auto box = patch_box({.corner = corner, .size = 61}, 1280, 1024);
    return std::array{box.left, box.top, box.width, box.height};
  };
  EXPECT_THAT(corner_of(Corner::UpperLeft), ElementsAre(0, 0, 61, 61));
  EXPECT_THAT(corner_of(Corner::UpperRight), ElementsAre(1219, 0, 61, 61));
  EXPECT_THAT(corner_of(Corner::LowerLeft), ElementsAre(0, 963, 61, 61));
  EXPECT_THAT(corner_of(Corner::LowerRight), ElementsAre(1219, 963, 61, 61));
  const auto box = patch_box({.centre = {{0.5, 0.25}}, .size = 60}, 1280, 1024);
  EXPECT_EQ(box.left, 610);
  EXPECT_EQ(box.top, 226);
}

}  // namespace
}  // namespace bimodal::protocols

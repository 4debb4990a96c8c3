#include "runner/preparation/sound_channels.hpp"

#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

TEST(SoundChannels, AreBothEarsUnlessTheProtocolNamesThem) {
  protocols::Protocol protocol;
  EXPECT_EQ(stimulus_channels(protocol.sound), kBothEars);
  EXPECT_EQ(channels_needed(protocol), 0);  // a device with one channel will do
  protocol.sound.channels = {4, 2};
  const auto channels = stimulus_channels(protocol.sound);
  EXPECT_TRUE(channels.has(1) && channels.has(3));
  EXPECT_FALSE(channels.has(0) || channels.has(2));
  EXPECT_EQ(channels_needed(protocol), 4);
}

TEST(SoundChannels, ReachAsFarAsTheClick) {
  protocols::Protocol protocol;
  protocol.triggers.click = protocols::Click{.channel = 5};
  EXPECT_EQ(channels_needed(protocol), 5);
  protocol.sound.channels = {7};
  EXPECT_EQ(channels_needed(protocol), 7);
}

TEST(ClickMarker, LeavesWithTheSampleOfTimeZero) {
  protocols::Protocol protocol;
  EXPECT_FALSE(click_marker(protocol, 500ms).has_value());
  protocol.sound.rate = Hertz{44'100};
  protocol.triggers.click = protocols::Click{.channel = 3, .length = 1ms, .amplitude = 0.25};
  const auto marker = click_marker(protocol, 500ms);
  ASSERT_TRUE(marker.has_value());
  EXPECT_EQ(marker->start, 22'050);
  EXPECT_EQ(*marker->samples, std::vector<float>(44, 0.25F));
  EXPECT_TRUE(marker->channels.has(2));
  EXPECT_EQ(marker->channels.channels_needed(), 3);
}

TEST(ClickMarker, HasAtLeastOneSample) {
  protocols::Protocol protocol;
  protocol.sound.rate = Hertz{8'000};
  protocol.triggers.click = protocols::Click{.channel = 3, .length = 10us};
  EXPECT_EQ(click_marker(protocol, 0ms)->samples->size(), 1U);
}

}  // namespace
}  // namespace bimodal::runner

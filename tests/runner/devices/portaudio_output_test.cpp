#include "runner/devices/portaudio/portaudio_output.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/devices/device_error.hpp"
#include "runner/devices/portaudio/output_channels.hpp"
#include "runner/devices/portaudio/portaudio_session.hpp"

namespace bimodal::runner {
namespace {

using ::testing::HasSubstr;

std::vector<AudioDevice> three_devices() {
  return {{.index = 0,
           .name = "hw:0,3",
           .host = "ALSA",
           .channels = 8,
           .default_rate = 48'000,
           .safe_latency = 0.01,
           .is_default = false},
          {.index = 4,
           .name = "hw:0",
           .host = "ALSA",
           .channels = 2,
           .default_rate = 44'100,
           .safe_latency = 0.01,
           .is_default = true},
          {.index = 5,
           .name = "system",
           .host = "JACK Audio Connection Kit",
           .channels = 2,
           .default_rate = 48'000,
           .safe_latency = 0.01,
           .is_default = false}};
}

std::string message_of(const std::vector<AudioDevice>& devices, const std::string& wanted) {
  try {
    (void)choose_device(devices, wanted);
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ChooseDevice, TakesTheDefaultAnIndexANameOrAPartOfOne) {
  const auto devices = three_devices();
  EXPECT_EQ(choose_device(devices, "").index, 5);  // a running JACK server is meant
  EXPECT_EQ(choose_device(devices, "5").index, 5);
  EXPECT_EQ(choose_device(devices, "hw:0").index, 4);  // whole before part
  EXPECT_EQ(choose_device(devices, "JACK").index, 5);
}

TEST(ChooseDevice, TakesTheFirstIfNoneIsTheDefault) {
  auto devices = three_devices();
  devices.at(1).is_default = false;
  devices.at(2).host = "OSS";
  EXPECT_EQ(choose_device(devices, "").index, 0);
}

TEST(ChooseDevice, ListsTheDevicesThatThereAre) {
  const auto message = message_of(three_devices(), "headphones");
  EXPECT_THAT(message, HasSubstr("cannot open the sound output 'headphones'"));
  EXPECT_THAT(message, HasSubstr("--audio none"));
  EXPECT_THAT(message,
              HasSubstr("\n  4: hw:0 (ALSA), 2 channels, 44100 samples per second, default"));
}

TEST(ChooseDevice, NamesTheWayOutIfThereIsNoDevice) {
  EXPECT_EQ(message_of({}, ""),
            "cannot open a sound output: this machine has none; connect one, start a sound server, "
            "or run a session without sound (`bimodal run ... --audio none`)");
}

TEST(ChooseChannels, TakesTwoOrTheOnlyOneUnlessMoreAreAskedFor) {
  AudioDevice device{.channels = 8};
  const auto any = [](int) { return true; };
  EXPECT_EQ(choose_channels(device, 0, any), 2);
  EXPECT_EQ(choose_channels(device, 3, any), 3);
  device.channels = 1;
  EXPECT_EQ(choose_channels(device, 0, any), 1);
}

TEST(ChooseChannels, TakesMoreWhereTheDriverRefusesTheVeryNumber) {
  const AudioDevice device{.channels = 8};
  EXPECT_EQ(choose_channels(device, 3, [](int count) { return count % 2 == 0; }), 4);
  EXPECT_EQ(choose_channels(device, 3, [](int count) { return count == 8; }), 8);
  EXPECT_EQ(choose_channels(device, 3, [](int) { return false; }), 3);
}

TEST(ChooseChannels, RefusesADeviceWithTooFewAndSaysWhatItHas) {
  const auto device = three_devices().at(1);
  try {
    (void)choose_channels(device, 3, [](int) { return true; });
    FAIL() << "not refused";
  } catch (const DeviceError& error) {
    EXPECT_THAT(error.what(), HasSubstr("hw:0 (ALSA), 2 channels"));
    EXPECT_THAT(error.what(), HasSubstr("asks for its channel 3, and it has 2"));
    EXPECT_THAT(error.what(), HasSubstr("/triggers/click/channel"));
  }
}

TEST(PortaudioOutput, SaysWhatToDoOnAMachineWithoutSound) {
  if (!describe_audio_devices().empty()) GTEST_SKIP() << "this machine has a sound output";
  EXPECT_THROW(PortaudioOutput{}, DeviceError);
}

TEST(PortaudioOutput, RefusesADeviceThatIsNotThere) {
  EXPECT_THROW(PortaudioOutput{{.device = "no such device"}}, DeviceError);
}

}  // namespace
}  // namespace bimodal::runner

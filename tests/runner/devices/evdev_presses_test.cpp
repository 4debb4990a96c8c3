#include "runner/devices/evdev/evdev_presses.hpp"

#include <array>
#include <filesystem>
#include <initializer_list>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/input.h>
#include <unistd.h>

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

/// A pipe in the place of an input device.
class Device {
 public:
  Device() { EXPECT_EQ(pipe2(ends_.data(), O_NONBLOCK | O_CLOEXEC), 0); }

  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  Device(Device&&) = delete;
  Device& operator=(Device&&) = delete;

  ~Device() { unplug(); }

  [[nodiscard]] int reading_end() const { return ends_[0]; }

  void send(unsigned type, unsigned code, int value, Duration at) const {
    input_event event{};
    const auto whole = std::chrono::floor<std::chrono::seconds>(at);
    event.input_event_sec = whole.count();
    event.input_event_usec = std::chrono::floor<std::chrono::microseconds>(at - whole).count();
    event.type = static_cast<__u16>(type);
    event.code = static_cast<__u16>(code);
    event.value = value;
    EXPECT_EQ(write(ends_[1], &event, sizeof(event)), static_cast<ssize_t>(sizeof(event)));
  }

  void unplug() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

TEST(EvdevPresses, TakesWhatGoesDownWithTheKernelsStamp) {
  const Device keyboard;
  EvdevPresses presses{std::vector<int>{keyboard.reading_end()}};
  EXPECT_TRUE(presses.collect().empty());
  keyboard.send(EV_MSC, MSC_SCAN, 458756, 12s + 345'678us);
  keyboard.send(EV_KEY, KEY_A, 1, 12s + 345'678us);
  keyboard.send(EV_SYN, SYN_REPORT, 0, 12s + 345'678us);
  keyboard.send(EV_KEY, KEY_A, 2, 12s + 600ms);  // repeated
  keyboard.send(EV_KEY, KEY_A, 0, 12s + 700ms);  // up
  keyboard.send(EV_KEY, BTN_LEFT, 1, 13s);
  const auto found = presses.collect();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].code, static_cast<std::uint32_t>(KEY_A));
  EXPECT_EQ(found[0].at, Instant{12s + 345'678us});
  EXPECT_EQ(found[1].code, static_cast<std::uint32_t>(BTN_LEFT));
  EXPECT_TRUE(presses.collect().empty());
  EXPECT_TRUE(presses.refusal().empty());
}

TEST(EvdevPresses, LetsWaitWhatIsTooMuchForOneCallAndLosesNothing) {
  const Device keyboard;
  EvdevPresses presses{std::vector<int>{keyboard.reading_end()}};
  for (int k = 0; k < 150; ++k) keyboard.send(EV_KEY, KEY_B, 1, 1s + k * 1ms);
  int found = 0;
  for (int call = 0; call < 4; ++call) {
    for (const auto& press : presses.collect()) EXPECT_EQ(press.at, Instant{1s + found++ * 1ms});
  }
  EXPECT_EQ(found, 150);
}

TEST(EvdevPresses, LeavesOutADeviceThatIsGoneAndReadsTheOthers) {
  Device gone;
  const Device stays;
  EvdevPresses presses{std::vector<int>{gone.reading_end(), stays.reading_end()}};
  gone.unplug();
  stays.send(EV_KEY, KEY_C, 1, 3s);
  EXPECT_EQ(presses.collect().size(), 1U);
  EXPECT_EQ(presses.devices(), 1U);
}

TEST(EvdevPresses, SaysWhyThereAreNone) {
  const EvdevPresses presses{std::filesystem::path{"/no/such/folder"}};
  EXPECT_EQ(presses.devices(), 0U);
  EXPECT_EQ(presses.refusal(), "no input devices in /no/such/folder");
}

}  // namespace
}  // namespace bimodal::runner

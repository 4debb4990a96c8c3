#include "runner/devices/local/socket_port.hpp"

#include <functional>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "runner/devices/device_error.hpp"
#include "runner/devices/local/line_client.hpp"
#include "runner/devices/triggers/trigger_sender.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

class SocketTriggers : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path path() const { return files_.folder() / "t.socket"; }

  /// Sends until the client, which the server may not have met yet, hears of it.
  static nlohmann::json first_heard(TriggerSender& sender,
                                    LineClient& client,
                                    const TriggerSignal& signal) {
    for (int tries = 0; tries < 1000; ++tries) {
      EXPECT_TRUE(sender.post(signal));
      static_cast<void>(sender.next_report());
      if (const auto line = client.next_line(20ms)) return nlohmann::json::parse(*line);
    }
    return {};
  }

  WrittenFiles files_;
};

TEST_F(SocketTriggers, TellEveryClientInALineOfJson) {
  TriggerSender sender{std::make_unique<SocketPort>(path())};
  auto first = LineClient::connect(path());
  auto second = LineClient::connect(path());
  ASSERT_TRUE(first && second);
  const TriggerSignal signal{.event = "visual_zero",
                             .condition = "\"both\", größer",
                             .trial = 3,
                             .planned = MonotonicClock{}.now()};
  const auto line = first_heard(sender, *first, signal);
  EXPECT_EQ(line.at("event"), "visual_zero");
  EXPECT_EQ(line.at("trial"), 3);
  EXPECT_EQ(line.at("condition"), "\"both\", größer");
  EXPECT_EQ(line.at("planned_ns"), signal.planned.time_since_epoch().count());
  EXPECT_GE(line.at("sent_ns"), line.at("planned_ns"));
  EXPECT_EQ(line.size(), 5U);
  EXPECT_EQ(first_heard(sender, *second, signal).at("event"), "visual_zero");
}

TEST_F(SocketTriggers, AreSentWhetherAnybodyListensOrNot) {
  TriggerSender sender{std::make_unique<SocketPort>(path())};
  ASSERT_TRUE(sender.post({.event = "response", .condition = "A"}));
  const MonotonicClock clock;
  const auto latest = clock.now() + 10s;
  std::optional<TriggerReport> report;
  while (!report && clock.now() < latest) {
    report = sender.next_report();
    std::this_thread::yield();
  }
  ASSERT_TRUE(report.has_value());
  EXPECT_TRUE(report->sent.has_value());
}

TEST_F(SocketTriggers, AreForThisUserOnlyAndLeaveNothingBehind) {
  {
    const SocketPort port{path()};

    struct stat found {};

    ASSERT_EQ(::stat(path().c_str(), &found), 0);
    EXPECT_EQ(found.st_mode & 0777U, 0600U);
    EXPECT_THROW(SocketPort{path()}, DeviceError);  // another session
  }
  EXPECT_FALSE(std::filesystem::exists(path()));
}

TEST_F(SocketTriggers, ClientThatDoesNotReadKeepsNobodyWaiting) {
  TriggerSender sender{std::make_unique<SocketPort>(path())};
  const auto idle = LineClient::connect(path());
  ASSERT_TRUE(idle.has_value());
  const MonotonicClock clock;
  int sent = 0;
  Duration longest{};
  const auto end = clock.now() + 30s;
  while (sent < 20'000 && clock.now() < end) {  // 2 MB
    const auto before = clock.now();
    const bool posted = sender.post({.event = "visual_zero", .condition = "A"});
    longest = std::max(longest, clock.now() - before);
    while (sender.next_report()) ++sent;
    if (!posted) std::this_thread::yield();
  }
  EXPECT_EQ(sent >= 20'000, true);
  EXPECT_LT(longest, 5s);
}

}  // namespace
}  // namespace bimodal::runner

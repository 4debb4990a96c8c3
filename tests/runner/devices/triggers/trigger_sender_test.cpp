#include "runner/devices/triggers/trigger_sender.hpp"

#include <new>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/devices/device_error.hpp"
#include "runner/devices/serial/serial_port.hpp"
#include "tests/runner/realtime/count_allocations.hpp"
#include "tests/support/pseudo_terminal.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

TriggerSignal signal(std::string_view event, std::uint8_t code, Instant planned) {
  return {.event = event, .condition = "AV", .trial = 3, .code = code, .planned = planned};
}

/// The next report; empty event if none comes for 10 s.
TriggerReport awaited(TriggerSender& sender) {
  const MonotonicClock clock;
  const auto latest = clock.now() + 10s;
  while (clock.now() < latest) {
    if (const auto report = sender.next_report()) return *report;
    std::this_thread::yield();
  }
  return {};
}

std::unique_ptr<SerialPort> serial_port(const PseudoTerminal& terminal,
                                        std::optional<Duration> reset_after = std::nullopt) {
  return std::make_unique<SerialPort>(
      SerialPort::Options{.port = terminal.port(), .baud = 115'200, .reset_after = reset_after});
}

TEST(SerialTriggers, ArriveInTheOrderOfTheirInstantsEachStamped) {
  const PseudoTerminal terminal;
  TriggerSender sender{serial_port(terminal)};
  const MonotonicClock clock;
  const auto now = clock.now();
  ASSERT_TRUE(sender.post(signal("later", 2, now + 30ms)));
  ASSERT_TRUE(sender.post(signal("at once", 1, now)));
  ASSERT_TRUE(sender.post(signal("last", 255, now + 60ms)));
  EXPECT_EQ(terminal.arrived(3), "\x01\x02\xff");
  for (const auto* event : {"at once", "later", "last"}) {
    const auto report = awaited(sender);
    EXPECT_EQ(report.signal.event, event);
    EXPECT_EQ(report.signal.trial, 3);
    ASSERT_TRUE(report.sent.has_value());
    EXPECT_GE(*report.sent, report.signal.planned);
    EXPECT_GT(report.uncertainty, 0ns);
    EXPECT_GE(*report.sent - report.uncertainty, report.signal.planned);  // never too early
    EXPECT_LE(*report.sent, clock.now());
  }
}

TEST(SerialTriggers, BytesAreNotChangedOnTheWay) {
  const PseudoTerminal terminal;
  TriggerSender sender{serial_port(terminal)};
  std::string sent;
  for (int code = 1; code <= 255; ++code) {
    while (!sender.post(signal("x", static_cast<std::uint8_t>(code), Instant{}))) {
    }
    sent.push_back(static_cast<char>(code));
    EXPECT_TRUE(awaited(sender).sent.has_value());
  }
  EXPECT_EQ(terminal.arrived(255), sent);
}

TEST(SerialTriggers, AreFollowedByZeroWhereAResetIsAskedFor) {
  const PseudoTerminal terminal;
  TriggerSender sender{serial_port(terminal, 5ms)};
  ASSERT_TRUE(sender.post(signal("visual_zero", 7, Instant{})));
  EXPECT_EQ(terminal.arrived(2), std::string("\x07\x00", 2));
}

TEST(SerialTriggers, LineIsLeftAtZeroWhenTheSessionEnds) {
  const PseudoTerminal terminal;
  {
    TriggerSender sender{serial_port(terminal, 1h)};
    ASSERT_TRUE(sender.post(signal("response", 4, Instant{})));
    EXPECT_TRUE(awaited(sender).sent.has_value());
  }
  EXPECT_EQ(terminal.arrived(2), std::string("\x04\x00", 2));
}

TEST(SerialTriggers, WhatIsNotDueAtTheEndIsNotSent) {
  const PseudoTerminal terminal;
  const MonotonicClock clock;
  {
    TriggerSender sender{serial_port(terminal)};
    ASSERT_TRUE(sender.post(signal("due", 1, clock.now())));
    ASSERT_TRUE(sender.post(signal("never", 2, clock.now() + 1h)));
  }
  EXPECT_EQ(terminal.arrived(1), "\x01");
}

TEST(SerialTriggers, PortThatVanishesIsReportedAndKeepsNobodyWaiting) {
  PseudoTerminal terminal;
  TriggerSender sender{serial_port(terminal)};
  terminal.unplug();
  for (const auto* event : {"visual_zero", "response"}) {
    ASSERT_TRUE(sender.post(signal(event, 1, Instant{})));
    const auto report = awaited(sender);
    EXPECT_EQ(report.signal.event, event);
    EXPECT_FALSE(report.sent.has_value());
  }
}

TEST(SerialTriggers, PortThatTakesNothingIsGivenUpAfterATenthOfASecond) {
  const PseudoTerminal terminal;  // whose far end is not read
  const SerialLine line{terminal.port(), 115'200};
  const MonotonicClock clock;
  Duration longest{};
  bool refused = false;
  for (int i = 0; i < 1'000'000 && !refused; ++i) {
    const auto before = clock.now();
    refused = !line.write(1);
    longest = std::max(longest, clock.now() - before);
  }
  EXPECT_TRUE(refused);
  EXPECT_GT(longest, 90ms);
}

TEST(SerialTriggers, PortThatIsNotThereIsRefusedWithTheWayOut) {
  try {
    const SerialPort port{{.port = "/dev/ttyNoSuchThing"}};
    FAIL() << "not refused";
  } catch (const DeviceError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the serial port '/dev/ttyNoSuchThing': "));
    EXPECT_THAT(error.what(), HasSubstr("there is no such port"));
    EXPECT_THAT(error.what(), HasSubstr("--no-triggers"));
  }
}

TEST(TriggerSender, PostingAllocatesNothing) {
  const PseudoTerminal terminal;
  TriggerSender sender{serial_port(terminal)};
  const auto before = allocations_of_this_thread();
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(sender.post(signal("visual_zero", 1, Instant{})));
    static_cast<void>(sender.next_report());
  }
  EXPECT_EQ(allocations_of_this_thread(), before);
}

/// Fails as memory may.
class FailingPort final : public TriggerPort {
 public:
  [[nodiscard]] bool send(const TriggerSignal& /*signal*/, Instant /*now*/) override {
    throw std::bad_alloc{};
  }

  [[nodiscard]] std::string_view kind() const override { return "failing"; }

  [[nodiscard]] std::string description() const override { return "fails"; }
};

TEST(TriggerSender, SurvivesAPortThatThrows) {
  TriggerSender sender{std::make_unique<FailingPort>()};
  ASSERT_TRUE(sender.post(signal("visual_zero", 1, Instant{})));
  EXPECT_FALSE(awaited(sender).sent.has_value());
}

}  // namespace
}  // namespace bimodal::runner

#include "runner/devices/triggers/signal_agenda.hpp"

#include <string>

#include <gtest/gtest.h>

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

constexpr Instant at(Duration since_start) {
  return Instant{since_start};
}

TriggerSignal signal(std::string_view event, Duration planned) {
  return {.event = event, .planned = at(planned)};
}

/// Everything that is due, in order, resets as "0".
std::string taken(SignalAgenda& agenda, Duration now) {
  std::string events;
  while (const auto task = agenda.take(at(now))) events += task->signal ? task->signal->event : "0";
  return events;
}

TEST(SignalAgenda, HasNothingToDoAtFirst) {
  SignalAgenda agenda;
  EXPECT_FALSE(agenda.next().has_value());
  EXPECT_FALSE(agenda.take(at(1h)).has_value());
}

TEST(SignalAgenda, GivesSignalsInTheOrderOfTheirInstantsAndNoneTooEarly) {
  SignalAgenda agenda;
  EXPECT_TRUE(agenda.add(signal("c", 30ms)));
  EXPECT_TRUE(agenda.add(signal("a", 10ms)));
  EXPECT_TRUE(agenda.add(signal("b", 10ms)));  // posted later: after it
  EXPECT_EQ(agenda.next(), at(10ms));
  EXPECT_EQ(taken(agenda, 9'999us), "");
  EXPECT_EQ(taken(agenda, 10ms), "ab");
  EXPECT_EQ(agenda.next(), at(30ms));
  EXPECT_EQ(taken(agenda, 1h), "c");
}

TEST(SignalAgenda, ResetsAfterTheLastCode) {
  SignalAgenda agenda;
  agenda.reset_at(at(20ms));
  EXPECT_EQ(agenda.next(), at(20ms));
  EXPECT_TRUE(agenda.add(signal("a", 15ms)));
  EXPECT_EQ(agenda.next(), at(15ms));
  EXPECT_TRUE(agenda.take(at(30ms))->signal.has_value());
  agenda.reset_at(at(25ms));  // of "a": the earlier one is put off
  EXPECT_EQ(taken(agenda, 24ms), "");
  EXPECT_EQ(taken(agenda, 30ms), "0");
  EXPECT_EQ(taken(agenda, 1h), "");
}

TEST(SignalAgenda, ResetsBeforeACodeThatComesLater) {
  SignalAgenda agenda;
  agenda.reset_at(at(20ms));
  EXPECT_TRUE(agenda.add(signal("a", 21ms)));
  EXPECT_EQ(taken(agenda, 30ms), "0a");
}

TEST(SignalAgenda, RefusesWhatItHasNoRoomFor) {
  SignalAgenda agenda;
  int added = 0;
  while (added < 1000 && agenda.add(signal("a", 1ms))) ++added;
  EXPECT_EQ(added, 32);
  EXPECT_EQ(taken(agenda, 1ms).size(), 32U);
  EXPECT_TRUE(agenda.add(signal("b", 1ms)));
}

}  // namespace
}  // namespace bimodal::runner

#include "runner/session/recording_machine.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using Phase = RecordingMachine::Phase;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A machine with its clock: each step takes some time.
class Session {
 public:
  explicit Session(std::vector<RecordingSlot> slots, const RecordingRules& rules = {})
      : machine_{std::move(slots), rules} {}

  std::vector<RecordingCommand> press(Key key, const std::string& text = {}) {
    now_ += 200ms;
    return take(machine_.on(Keystroke{.key = key, .text = text, .at = now_, .source = "test"}));
  }

  std::vector<RecordingCommand> type(const std::string& text) { return press(Key::Text, text); }

  std::vector<RecordingCommand> wait(Duration time, std::optional<Duration> silence = {}) {
    now_ += time;
    return take(machine_.on(Moment{now_, silence}));
  }

  void judge(bool good, bool kept = true) {
    take(machine_.on(TakeJudged{.at = now_, .good = good, .kept = kept}));
  }

  /// From the welcome to the first word.
  void listen_to_the_room() {
    type(" ");
    wait(2s);
    take(machine_.on(RoomJudged{now_, true}));
  }

  /// From Ready or Doubt to a judgement.
  void say(bool good) {
    type(" ");
    wait(300ms);
    wait(1s, 600ms);
    judge(good);
  }

  /// As say(true), and on to the next word.
  void say_well() {
    say(true);
    wait(800ms);
  }

  template <typename Command>
  [[nodiscard]] int count() const {
    return static_cast<int>(std::ranges::count_if(
        all_, [](const auto& command) { return std::holds_alternative<Command>(command); }));
  }

  [[nodiscard]] const RecordingMachine& machine() const { return machine_; }

  [[nodiscard]] std::string word() const { return machine_.slots()[machine_.slot()].text; }

  [[nodiscard]] Phase phase() const { return machine_.phase(); }

 private:
  std::vector<RecordingCommand> take(std::vector<RecordingCommand> commands) {
    all_.insert(all_.end(), commands.begin(), commands.end());
    return commands;
  }

  RecordingMachine machine_;
  Instant now_{10s};
  std::vector<RecordingCommand> all_;
};

std::vector<RecordingSlot> three() {
  return {{"stew", false}, {"zoo", false}, {"cat", false}};
}

TEST(RecordingMachine, LeadsFromTheRoomThroughTheWordsToTheEnd) {
  Session session{three()};
  EXPECT_EQ(session.phase(), Phase::Welcome);
  EXPECT_THAT(session.type(" "), SizeIs(1));
  EXPECT_THAT(session.wait(1999ms), IsEmpty());
  const auto room = session.wait(1ms);
  ASSERT_THAT(room, SizeIs(1));
  EXPECT_TRUE(std::holds_alternative<EndRoom>(room[0]));
  Session whole{three()};
  whole.listen_to_the_room();
  for (const auto* word : {"stew", "zoo", "cat"}) {
    EXPECT_EQ(whole.phase(), Phase::Ready);
    EXPECT_EQ(whole.word(), word);
    whole.say_well();
  }
  EXPECT_EQ(whole.phase(), Phase::Complete);
  const auto end = whole.press(Key::Enter);
  ASSERT_THAT(end, SizeIs(1));
  EXPECT_TRUE(std::get<EndRecording>(end[0]).complete);
  EXPECT_EQ(whole.count<EndTake>(), 3);
  EXPECT_EQ(whole.count<BeginCapture>(), 4);
}

TEST(RecordingMachine, CapturesOnlyWhenTheClickOfTheKeyHasDiedAway) {
  Session session{three()};
  session.listen_to_the_room();
  EXPECT_THAT(session.press(Key::Enter), IsEmpty());
  EXPECT_EQ(session.phase(), Phase::Arming);
  EXPECT_THAT(session.wait(299ms), IsEmpty());
  EXPECT_THAT(session.wait(1ms), SizeIs(1));
  EXPECT_EQ(session.phase(), Phase::Recording);
}

TEST(RecordingMachine, EndsATakeBySilenceByTheLimitOrByHand) {
  const auto recording = [] {
    Session session{three()};
    session.listen_to_the_room();
    session.type(" ");
    session.wait(300ms);
    return session;
  };
  auto by_silence = recording();
  EXPECT_THAT(by_silence.wait(2s, 590ms), IsEmpty());
  EXPECT_THAT(by_silence.wait(10ms, 600ms), SizeIs(1));
  auto by_limit = recording();
  EXPECT_THAT(by_limit.wait(4999ms), IsEmpty());
  EXPECT_THAT(by_limit.wait(1ms), SizeIs(1));
  auto by_hand = recording();
  by_hand.wait(1s);
  EXPECT_THAT(by_hand.press(Key::Enter), SizeIs(1));
}

TEST(RecordingMachine, DoesNotTakeAHeldSpaceForASecondOne) {
  RecordingMachine machine{three(), {}};
  Instant now{1s};
  const auto press_space = [&] {
    return machine.on(Keystroke{.key = Key::Text, .text = " ", .at = now, .source = "test"});
  };
  static_cast<void>(press_space());
  static_cast<void>(machine.on(Moment{now += 2s}));
  static_cast<void>(machine.on(RoomJudged{now, true}));
  static_cast<void>(press_space());
  now += 500ms;  // the first repetition
  for (int refresh = 0; refresh < 60; ++refresh) {
    EXPECT_THAT(press_space(), IsEmpty());
    static_cast<void>(machine.on(Moment{now += 33ms}));
  }
  EXPECT_EQ(machine.phase(), Phase::Recording);
}

TEST(RecordingMachine, AsksForADoubtfulTakeAgainAndLetsItBeKept) {
  Session session{three()};
  session.listen_to_the_room();
  session.say(false);
  EXPECT_EQ(session.phase(), Phase::Doubt);
  EXPECT_EQ(session.machine().done(), 0U);
  session.wait(1h);
  EXPECT_EQ(session.phase(), Phase::Doubt);
  session.say(false);
  EXPECT_EQ(session.machine().attempts(), 2);
  EXPECT_TRUE(session.machine().can_keep());
  const auto commands = session.type("k");
  ASSERT_THAT(commands, SizeIs(1));
  EXPECT_EQ(std::get<KeepTake>(commands[0]).slot, 0U);
  EXPECT_EQ(session.word(), "zoo");
  EXPECT_EQ(session.machine().done(), 1U);
}

TEST(RecordingMachine, CannotKeepWhatWasNotHeard) {
  Session session{three()};
  session.listen_to_the_room();
  session.type(" ");
  session.wait(300ms);
  session.wait(5s);
  session.judge(false, false);
  EXPECT_FALSE(session.machine().can_keep());
  EXPECT_THAT(session.type("K"), IsEmpty());
  EXPECT_EQ(session.phase(), Phase::Doubt);
}

TEST(RecordingMachine, RejectsTheLastTakeOnRequestAndAsksForItAgain) {
  Session praised{three()};
  praised.listen_to_the_room();
  praised.say(true);
  const auto at_once = praised.type("r");
  ASSERT_THAT(at_once, SizeIs(1));
  EXPECT_EQ(std::get<RejectTake>(at_once[0]).slot, 0U);
  EXPECT_EQ(praised.word(), "stew");
  EXPECT_EQ(praised.machine().done(), 0U);

  Session later{three()};
  later.listen_to_the_room();
  later.say_well();
  EXPECT_EQ(later.word(), "zoo");
  EXPECT_THAT(later.press(Key::Backspace), SizeIs(1));
  EXPECT_EQ(later.word(), "stew");
  later.say_well();
  EXPECT_EQ(later.word(), "zoo");
}

TEST(RecordingMachine, GoesBackWithoutRejectingAnything) {
  Session session{three()};
  session.listen_to_the_room();
  session.say_well();
  EXPECT_THAT(session.press(Key::Left), IsEmpty());
  EXPECT_EQ(session.word(), "stew");
  EXPECT_EQ(session.machine().done(), 1U);
  session.press(Key::Left);
  EXPECT_EQ(session.word(), "stew");
  session.type("s");
  EXPECT_EQ(session.word(), "zoo");
  session.press(Key::Left);
  session.say(true);
  EXPECT_EQ(session.count<RejectTake>(), 0);
  session.wait(800ms);
  EXPECT_EQ(session.word(), "zoo");
}

TEST(RecordingMachine, PassesOverAWordAndEndsIncomplete) {
  Session session{three()};
  session.listen_to_the_room();
  session.type("s");
  EXPECT_EQ(session.word(), "zoo");
  session.say_well();
  session.say_well();
  EXPECT_EQ(session.phase(), Phase::Complete);
  const auto end = session.type(" ");
  EXPECT_FALSE(std::get<EndRecording>(end.at(0)).complete);
}

TEST(RecordingMachine, BeginsWithTheFirstWordThatIsNotDone) {
  Session session{{{"stew", true}, {"zoo", false}, {"cat", true}, {"dog", false}}};
  session.listen_to_the_room();
  EXPECT_EQ(session.word(), "zoo");
  session.say_well();
  EXPECT_EQ(session.word(), "dog");
  session.say_well();
  EXPECT_EQ(session.phase(), Phase::Complete);
}

TEST(RecordingMachine, AsksBeforeItStopsAndDropsWhatIsBeingSaid) {
  Session session{three()};
  session.listen_to_the_room();
  session.type(" ");
  session.wait(300ms);
  const auto dropped = session.press(Key::Escape);
  ASSERT_THAT(dropped, SizeIs(1));
  EXPECT_TRUE(std::holds_alternative<DropCapture>(dropped[0]));
  EXPECT_EQ(session.phase(), Phase::Confirming);
  session.press(Key::Enter);
  EXPECT_EQ(session.phase(), Phase::Ready);
  session.press(Key::WindowClosed);
  const auto end = session.press(Key::Escape);
  ASSERT_THAT(end, SizeIs(1));
  EXPECT_FALSE(std::get<EndRecording>(end[0]).complete);
}

TEST(RecordingMachine, DoesNotGoOnFromANoisyRoomByItself) {
  RecordingMachine machine{three(), {}};
  static_cast<void>(machine.on(Keystroke{.key = Key::Enter, .text = {}, .at = Instant{1s}}));
  static_cast<void>(machine.on(Moment{Instant{3s}}));
  static_cast<void>(machine.on(RoomJudged{Instant{3s}, false}));
  EXPECT_EQ(machine.phase(), Phase::RoomDoubt);
  EXPECT_THAT(
      machine.on(Keystroke{.key = Key::Text, .text = " ", .at = Instant{4s}, .source = "test"}),
      SizeIs(1));
  EXPECT_EQ(machine.phase(), Phase::Room);
}

TEST(RecordingMachine, NeedsNoKeysIfAutomaticUntilWordsFailThreeTimes) {
  RecordingRules rules;
  rules.automatic = true;
  Session session{three(), rules};
  session.listen_to_the_room();
  session.wait(1s);
  EXPECT_EQ(session.phase(), Phase::Arming);
  session.wait(300ms);
  session.wait(1s, 600ms);
  session.judge(true);
  session.wait(800ms);
  for (int attempt = 1; attempt <= 3; ++attempt) {
    EXPECT_EQ(session.word(), "zoo");
    session.wait(3s);
    session.wait(300ms);
    session.wait(5s);
    session.judge(false, false);
  }
  session.wait(1h);
  EXPECT_EQ(session.phase(), Phase::Doubt);
  EXPECT_TRUE(session.machine().awaits_key());
}

/// Whatever happens, in whatever order, commands fit what was asked before.
TEST(RecordingMachine, KeepsCapturesAndTakesInOrderWhateverIsPressed) {
  const std::vector<std::string> letters{" ", "r", "s", "k", "x", "é", ""};
  for (Seed seed = 0; seed < 300; ++seed) {
    Random random{seed};
    RecordingRules rules;
    rules.automatic = seed % 2 == 1;
    RecordingMachine machine{{{"a", false}, {"b", seed % 3 == 0}, {"c", false}}, rules};
    Instant now{1s};
    bool captures = false;
    std::vector<bool> counts{false, seed % 3 == 0, false};
    for (int step = 0; step < 400 && machine.phase() != Phase::Ended; ++step) {
      now += std::chrono::milliseconds{random.below(900)};
      std::optional<RecordingEvent> event;
      switch (random.below(4)) {
        case 0:
          event = Keystroke{.key = Key::Text,
                            .text = letters[random.below(letters.size())],
                            .at = now,
                            .source = "test"};
          break;
        case 1:
          // Escape once in a while only, or every session would be short.
          event = Keystroke{.key = static_cast<Key>(random.below(random.below(9) == 0 ? 6 : 4)),
                            .text = "?",
                            .at = now,
                            .source = "test"};
          break;
        default:
          event = Moment{now, random.below(2) == 0 ? std::nullopt : std::optional{Duration{700ms}}};
      }
      for (const auto& command : machine.on(*event)) {
        if (std::holds_alternative<BeginCapture>(command)) {
          EXPECT_FALSE(captures);
          captures = true;
        } else if (std::holds_alternative<DropCapture>(command)) {
          EXPECT_TRUE(captures);
          captures = false;
        } else if (std::holds_alternative<EndRoom>(command)) {
          EXPECT_TRUE(captures);
          captures = false;
          EXPECT_THAT(machine.on(RoomJudged{now, random.below(4) != 0}), IsEmpty());
        } else if (const auto* end = std::get_if<EndTake>(&command)) {
          EXPECT_TRUE(captures);
          captures = false;
          const bool good = random.below(2) == 0;
          if (good) counts[end->slot] = true;
          EXPECT_THAT(machine.on(TakeJudged{now, good, good || random.below(2) == 0}), IsEmpty());
        } else if (const auto* keep = std::get_if<KeepTake>(&command)) {
          counts[keep->slot] = true;
        } else if (const auto* reject = std::get_if<RejectTake>(&command)) {
          EXPECT_TRUE(counts[reject->slot]);
          counts[reject->slot] = false;
        }
      }
      for (std::size_t slot = 0; slot < counts.size(); ++slot) {
        ASSERT_EQ(machine.slots()[slot].done, counts[slot]) << seed << " " << step;
      }
      ASSERT_EQ(captures, machine.phase() == Phase::Room || machine.phase() == Phase::Recording);
    }
  }
}

TEST(RecordingMachine, IgnoresClicksAndButtonsEvenBetweenTheRepeatsOfAHeldKey) {
  RecordingMachine machine{{{"a", false}}, {}};
  const auto press = [&machine](Key key, Instant at) {
    return machine.on(
        Keystroke{.key = key, .text = key == Key::Text ? " " : "", .at = at, .source = "test"});
  };
  EXPECT_THAT(press(Key::Pointer, Instant{1s}), IsEmpty());
  EXPECT_THAT(press(Key::Button, Instant{1s}), IsEmpty());
  EXPECT_EQ(machine.phase(), Phase::Welcome);
  EXPECT_THAT(press(Key::Enter, Instant{2s}), SizeIs(1));
  EXPECT_EQ(machine.phase(), Phase::Room);
  EXPECT_THAT(machine.on(Moment{Instant{4s}}), SizeIs(1));
  EXPECT_THAT(machine.on(RoomJudged{Instant{4s}, true}), IsEmpty());
  EXPECT_THAT(press(Key::Enter, Instant{5s}), IsEmpty());
  EXPECT_EQ(machine.phase(), Phase::Arming);
  static_cast<void>(machine.on(Moment{Instant{5s + 300ms}}));
  EXPECT_EQ(machine.phase(), Phase::Recording);
  EXPECT_THAT(press(Key::Left, Instant{5s + 310ms}), SizeIs(1));
  EXPECT_EQ(machine.phase(), Phase::Ready);
  EXPECT_THAT(press(Key::Pointer, Instant{5s + 320ms}), IsEmpty());
  EXPECT_THAT(press(Key::Left, Instant{5s + 330ms}), IsEmpty());
  EXPECT_EQ(machine.phase(), Phase::Ready);
}

}  // namespace
}  // namespace bimodal::runner

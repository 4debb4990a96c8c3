#include "runner/devices/simulated/simulated_keyboard.hpp"

#include <gtest/gtest.h>

#include "runner/devices/simulated/virtual_clock.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

std::string text_of(const std::vector<Keystroke>& keystrokes) {
  std::string text;
  for (const auto& keystroke : keystrokes) text += keystroke.text;
  return text;
}

TEST(SimulatedKeyboard, TypesNothingUnasked) {
  const VirtualClock clock{Instant{1h}};
  SimulatedKeyboard keyboard{clock};
  EXPECT_TRUE(keyboard.poll().empty());
}

TEST(SimulatedKeyboard, TypesTheAnswerKeyByKeyAndThenEnter) {
  VirtualClock clock;
  SimulatedKeyboard keyboard{clock};
  keyboard.expect("bat", Instant{10s});
  clock.advance_to(Instant{10s + 600ms - 1ns});
  EXPECT_TRUE(keyboard.poll().empty());
  clock.advance_to(Instant{10s + 600ms});
  const auto first = keyboard.poll();
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].text, "b");
  EXPECT_EQ(first[0].key, Key::Text);
  EXPECT_EQ(first[0].at, Instant{10s + 600ms});
  EXPECT_EQ(first[0].source, "simulated");
  clock.advance_to(Instant{10s + 850ms});
  EXPECT_EQ(text_of(keyboard.poll()), "at");
  clock.advance_to(Instant{20s});
  const auto last = keyboard.poll();
  ASSERT_EQ(last.size(), 1U);
  EXPECT_EQ(last[0].key, Key::Enter);
  EXPECT_EQ(last[0].at, Instant{10s + 600ms + 3 * 120ms});
  EXPECT_TRUE(keyboard.poll().empty());
}

TEST(SimulatedKeyboard, AnswersAPromptWithEnterAlone) {
  VirtualClock clock;
  SimulatedKeyboard keyboard{clock};
  keyboard.expect("", Instant{});
  clock.advance_to(Instant{600ms});
  const auto keystrokes = keyboard.poll();
  ASSERT_EQ(keystrokes.size(), 1U);
  EXPECT_EQ(keystrokes[0].key, Key::Enter);
}

TEST(SimulatedKeyboard, TypesWholeCharactersOfUtf8) {
  VirtualClock clock;
  SimulatedKeyboard keyboard{clock};
  keyboard.expect("né€😀", Instant{});
  clock.advance_to(Instant{1h});
  const auto keystrokes = keyboard.poll();
  ASSERT_EQ(keystrokes.size(), 5U);
  EXPECT_EQ(keystrokes[1].text, "é");
  EXPECT_EQ(keystrokes[2].text, "€");
  EXPECT_EQ(keystrokes[3].text, "😀");
}

TEST(SimulatedKeyboard, DropsWhatIsLeftOfAnEarlierAnswer) {
  VirtualClock clock;
  SimulatedKeyboard keyboard{clock};
  keyboard.expect("first", Instant{});
  clock.advance_to(Instant{600ms});
  EXPECT_EQ(text_of(keyboard.poll()), "f");
  keyboard.expect("x", clock.now());
  clock.advance_to(Instant{1h});
  EXPECT_EQ(text_of(keyboard.poll()), "x");
}

TEST(SimulatedKeyboard, GivesChoicesByTheirStroke) {
  VirtualClock clock;
  for (const bool confirms : {false, true}) {
    SimulatedKeyboard keyboard{
        clock,
        {.choices = {{"ba", {.key = Key::Button, .button = 2}}}, .confirms_choice = confirms}};
    const auto from = clock.now();
    keyboard.expect("ba", from);
    clock.advance_by(std::chrono::seconds{1});
    const auto strokes = keyboard.poll();
    ASSERT_EQ(strokes.size(), confirms ? 2U : 1U);
    EXPECT_EQ(strokes[0].key, Key::Button);
    EXPECT_EQ(strokes[0].button, 2);
    EXPECT_EQ(strokes[0].at, from + std::chrono::milliseconds{600});
    EXPECT_EQ(strokes[0].source, "simulated");
    keyboard.expect("", clock.now());  // a page
    clock.advance_by(std::chrono::seconds{1});
    EXPECT_EQ(keyboard.poll().at(0).key, Key::Enter);
  }
}

TEST(SimulatedKeyboard, SaysThatNobodyTypes) {
  const VirtualClock clock;
  EXPECT_EQ(SimulatedKeyboard{clock}.description(),
            "simulated: the first key 600 ms after an answer is awaited, then every 120 ms");
}

}  // namespace
}  // namespace bimodal::runner

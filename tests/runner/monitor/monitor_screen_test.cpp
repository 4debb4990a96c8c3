#include "runner/monitor/monitor_screen.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/monitor/screen_text.hpp"
#include "runner/monitor/session_chronicle.hpp"
#include "tests/support/damage.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;

constexpr Instant kNow{200s};

/// The lines of a session in its fourth trial.
std::vector<std::string> told_lines(const std::string& title = "Words") {
  SessionChronicle chronicle{{.participant = "P01",
                              .title = title,
                              .data = "words.sqlite",
                              .trials = 8,
                              .blocks = 2,
                              .conditions = {"A", "AV"},
                              .display = "a screen",
                              .audio = "a sound card"}};
  std::vector<std::string> lines{chronicle.description_line(Instant{90s}).text};
  const auto tell = [&](const Progress& progress) {
    for (const auto& line : chronicle.on(progress)) lines.push_back(line.text);
  };
  protocols::PlannedTrial trial{.word = {.spelling = "stew"}};
  Instant at{100s};
  for (trial.index = 0; trial.index < 3; ++trial.index) {
    trial.condition = trial.index % 2;
    tell(TrialReached{at, trial, 8, TrialState::Preparing});
    at += 30s;
    tell(TrialReached{at, trial, 8, TrialState::Stored});
    tell(TrialResult{.at = at,
                     .trial = trial,
                     .response = trial.index == 1 ? "shoe" : "stew",
                     .flagged = trial.index == 1,
                     .events = {}});
    tell(Health{.at = at,
                .refresh_period = 16'666'667ns,
                .refresh_deviation = 20us,
                .refreshes_measured = 100,
                .late_frames = 4,
                .sound_drift_ppm = -3.25,
                .longest_storing = 1'340us});
  }
  tell(TrialReached{at, trial, 8, TrialState::Responding});
  return lines;
}

SessionPicture picture_of(const std::vector<std::string>& lines) {
  SessionPicture picture;
  for (const auto& line : lines) EXPECT_NE(picture.take(line), "");
  return picture;
}

TEST(MonitorScreen, TellsWhatTheExperimenterWantsToKnow) {
  const auto rows = monitor_screen(picture_of(told_lines()), kNow, {}, "keys");
  EXPECT_THAT(rows[0], AllOf(StartsWith("Words"), HasSubstr("P01   session 1")));
  EXPECT_THAT(rows, Contains(HasSubstr("trial 4 of 8   block 1 of 2")));
  EXPECT_THAT(rows, Contains(HasSubstr("responding")));
  EXPECT_THAT(rows, Contains(HasSubstr("elapsed 1:40  about 3 min left")));
  EXPECT_THAT(rows, Contains(HasSubstr("stored 3   flagged 1")));
  EXPECT_THAT(rows, Contains(HasSubstr("refresh 16.667 ms, SD 0.020 ms")));
  EXPECT_THAT(rows, Contains(HasSubstr("late frames 4")));
  EXPECT_THAT(rows, Contains(HasSubstr("drift -3.2 ppm")));
  EXPECT_THAT(rows, Contains(HasSubstr("answers stored within 1.3 ms")));
  EXPECT_THAT(rows, Contains(AllOf(StartsWith("A "), HasSubstr("2     2  100 %"))));
  EXPECT_THAT(rows, Contains(AllOf(StartsWith("AV"), HasSubstr("1     0    0 %"))));
  EXPECT_THAT(rows, Contains(HasSubstr("2! AV       stew -> shoe")));
  EXPECT_THAT(rows, Contains(HasSubstr("3  A        stew = stew")));
  EXPECT_THAT(rows.back(), StartsWith("keys"));
}

TEST(MonitorScreen, FitsAnyTerminal) {
  const auto picture = picture_of(told_lines(std::string(300, 'x')));
  for (const std::size_t columns : {1U, 20U, 79U, 80U, 200U}) {
    for (const std::size_t rows : {1U, 5U, 12U, 24U, 60U}) {
      const auto screen = monitor_screen(picture, kNow, {columns, rows}, "keys");
      EXPECT_LE(screen.size(), rows);
      for (const auto& row : screen) EXPECT_THAT(row, SizeIs(columns));
    }
  }
}

TEST(MonitorScreen, TellsThatASessionIsPausedAndWhy) {
  auto picture = picture_of(told_lines());
  picture.take(R"({"kind":"pause","state":"asked","reason":"the telephone"})");
  EXPECT_THAT(monitor_screen(picture, kNow, {}, ""), Contains(HasSubstr("pause asked")));
  picture.take(R"({"kind":"pause","state":"paused","reason":"the telephone"})");
  EXPECT_THAT(monitor_screen(picture, kNow, {}, ""),
              AllOf(Contains(HasSubstr("PAUSED")), Contains(StartsWith("pause: the telephone"))));
}

TEST(MonitorScreen, TellsWhichPageIsRead) {
  auto picture = picture_of(told_lines());
  picture.take(
      R"({"kind":"page","at_ns":195000000000,"text":"Rest.\nThen go on.","is_break":true})");
  EXPECT_THAT(monitor_screen(picture, kNow, {}, ""), Contains(HasSubstr(R"(break: "Rest.?Then)")));
}

TEST(MonitorScreen, TellsOfALostSoundDevice) {
  auto picture = picture_of(told_lines());
  picture.take(R"({"kind":"health","sound_lost":true})");
  EXPECT_THAT(monitor_screen(picture, kNow, {}, ""), Contains(HasSubstr("THE DEVICE IS LOST")));
}

TEST(MonitorScreen, ShowsNothingThatATerminalWouldActOn) {
  EXPECT_EQ(harmless("a\x1b[2Jb\x7f\tc"), "a?[2Jb??c");
  EXPECT_EQ(harmless("\xc2\x9b"
                     "31m \xc3\xa9 \xff"),
            "?31m \xc3\xa9 ?");
  const auto picture = picture_of(told_lines("\x1b]0;mine\x07"));
  for (const auto& row : monitor_screen(picture, kNow, {}, "keys")) {
    EXPECT_THAT(row, Not(HasSubstr("\x1b")));
  }
}

TEST(MonitorScreen, TakesWhateverLinesComeFromAnotherVersion) {
  const auto lines = told_lines();
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    SessionPicture picture;
    Damage damage{seed};
    for (const auto& line : lines) picture.take(damage(line));
    EXPECT_THAT(monitor_screen(picture, kNow, {}, "keys"), SizeIs(testing::Le(24U)));
    static_cast<void>(news_line(picture, "result"));
    static_cast<void>(end_text(picture));
  }
  SessionPicture strange;
  strange.take(R"({"kind":"trial","trial":-1,"of":1e300,"state":{}})");
  strange.take(R"({"kind":"times","at_ns":9223372036854775807,"elapsed_ns":-9223372036854775808})");
  strange.take(R"({"kind":"tally","conditions":[1,null,{"trials":-3}],"latest":{"a":1}})");
  EXPECT_THAT(monitor_screen(strange, kNow, {}, ""), Not(IsEmpty()));
}

TEST(MonitorScreen, SaysHowManyConditionsHaveNoRoom) {
  std::vector<ConditionTally> tallies(9, {.condition = "A", .trials = 1});
  EXPECT_THAT(condition_table(tallies, 10), SizeIs(10));
  const auto shorter = condition_table(tallies, 6);
  ASSERT_THAT(shorter, SizeIs(6));
  EXPECT_EQ(shorter.back(), "and 5 more");
}

TEST(MonitorScreen, WritesTimesAsPeopleDo) {
  EXPECT_EQ(clock_text(62s), "1:02");
  EXPECT_EQ(clock_text(3'723s + 900ms), "1:02:03");
  EXPECT_EQ(clock_text(-5s), "0:00");
  EXPECT_EQ(rough_text(20s), "less than a minute");
  EXPECT_EQ(rough_text(29min + 10s), "about 29 min");
  EXPECT_EQ(rough_text(70min), "about 1 h 10 min");
}

TEST(MonitorScreen, TellsHowASessionEnded) {
  auto picture = picture_of(told_lines());
  EXPECT_THAT(end_text(picture), HasSubstr("gone without a word"));
  picture.take(R"({"kind":"ended","outcome":"failed","detail":"no disk","stored":3,"of":8})");
  EXPECT_EQ(end_text(picture), "failed: 3 of 8 trials stored in words.sqlite, 0 flagged; no disk");
}

TEST(MonitorScreen, ShowsWhatAFileHolds) {
  StoredSession session{.session = {.participant = "P01", .protocol_title = "Words"},
                        .outcome = "",
                        .planned_trials = 3};
  session.trials.push_back({{.phase = "main", .word = "stew", .condition = "A"}, {}});
  session.trials.back().trial.response.text = "STEW";
  session.trials.push_back(
      {{.phase = "main", .word = "ba", .visual_word = "da", .condition = "A"}, {}});
  const auto rows = stored_screen({session});
  ASSERT_THAT(rows, SizeIs(3));
  EXPECT_THAT(rows[0], AllOf(StartsWith("P01   Words"), HasSubstr("interrupted: 2 of 3 trials")));
  EXPECT_THAT(rows[2], AllOf(HasSubstr("A "), HasSubstr("2     1  100 %")));
}

}  // namespace
}  // namespace bimodal::runner

#include "runner/monitor/session_chronicle.hpp"

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

SessionDescription description() {
  return {.participant = "P01",
          .title = "Words",
          .data = "words.sqlite",
          .trials = 10,
          .blocks = 2,
          .conditions = {"A", "V"},
          .display = "a screen",
          .audio = "a sound card"};
}

class SessionChronicleTest : public testing::Test {
 protected:
  /// Takes the lines of what was told, by kind.
  void tell(const Progress& progress) {
    for (const auto& line : chronicle_.on(progress)) {
      EXPECT_EQ(line.text.find('\n'), std::string::npos);
      told_[line.kind] = json::parse(line.text);
      EXPECT_EQ(told_[line.kind].at("kind"), line.kind);
    }
  }

  void reach(TrialState state, Instant at) {
    tell(TrialReached{.at = at, .trial = trial_, .of = 10, .state = state});
  }

  /// A trial that lasts so long.
  void answer(const std::string& response, Duration lasting = 4s) {
    reach(TrialState::Preparing, now_);
    now_ += lasting;
    reach(TrialState::Stored, now_);
    tell(TrialResult{.at = now_, .trial = trial_, .response = response});
    ++trial_.index;
  }

  protocols::PlannedTrial trial_{.block = 1, .word = {.spelling = "stew"}, .condition = 1};
  Instant now_{100s};
  SessionChronicle chronicle_{description()};
  std::map<std::string, json> told_;
};

TEST_F(SessionChronicleTest, DescribesTheSession) {
  const auto line = json::parse(chronicle_.description_line(Instant{1s}).text);
  EXPECT_EQ(line.at("participant"), "P01");
  EXPECT_EQ(line.at("trials"), 10);
  EXPECT_EQ(line.at("conditions"), json({"A", "V"}));
  EXPECT_TRUE(line.at("verdict").is_null());
  chronicle_.judge("good");
  EXPECT_EQ(json::parse(chronicle_.description_line(Instant{1s}).text).at("verdict"), "good");
}

TEST_F(SessionChronicleTest, TellsWhichTrialIsInWhatState) {
  reach(TrialState::Responding, Instant{3s});
  const auto& line = told_.at("trial");
  EXPECT_EQ(line.at("trial"), 0);
  EXPECT_EQ(line.at("of"), 10);
  EXPECT_EQ(line.at("block"), 1);
  EXPECT_EQ(line.at("phase"), "main");
  EXPECT_EQ(line.at("condition"), "V");
  EXPECT_EQ(line.at("word"), "stew");
  EXPECT_EQ(line.at("state"), "responding");
  EXPECT_EQ(line.at("at_ns"), 3'000'000'000);
}

TEST_F(SessionChronicleTest, TellsWhetherAResponseIsSpelledAsTheTarget) {
  answer("Stew");
  EXPECT_EQ(told_.at("result").at("spelled_as_target"), true);
  answer("stu");
  EXPECT_EQ(told_.at("result").at("spelled_as_target"), false);
  trial_.word.seen = SeenWord{.spelling = "shoe"};
  answer("stew");
  EXPECT_TRUE(told_.at("result").at("spelled_as_target").is_null());
  const auto& condition = told_.at("tally").at("conditions").at(1);
  EXPECT_EQ(condition.at("trials"), 3);
  EXPECT_EQ(condition.at("judged"), 2);
  EXPECT_EQ(condition.at("spelled_as_target"), 1);
  EXPECT_EQ(told_.at("tally").at("latest").size(), 3U);
}

TEST_F(SessionChronicleTest, EstimatesTheTimeLeftFromTrialsWithoutTheirPauses) {
  answer("stew");
  answer("stew");
  EXPECT_TRUE(told_.at("times").at("left_ns").is_null());
  reach(TrialState::Preparing, now_);
  tell(PauseChanged{now_, PauseChanged::State::Paused, "the telephone"});
  EXPECT_EQ(told_.at("pause").at("state"), "paused");
  EXPECT_EQ(told_.at("pause").at("reason"), "the telephone");
  now_ += 10min;
  tell(PauseChanged{now_, PauseChanged::State::Running, ""});
  now_ += 4s;
  reach(TrialState::Stored, now_);
  tell(TrialResult{.at = now_, .trial = trial_, .response = "stew"});
  EXPECT_EQ(told_.at("times").at("typical_trial_ns"), Duration{4s}.count());
  EXPECT_EQ(told_.at("times").at("trials_to_come"), 7);
  EXPECT_EQ(told_.at("times").at("left_ns"), Duration{28s}.count());
  EXPECT_EQ(told_.at("times").at("elapsed_ns"), Duration{10min + 12s}.count());
}

TEST_F(SessionChronicleTest, CountsTheWholeSessionWhenItGoesOn) {
  auto resumed = description();
  resumed.stored_before = 6;
  resumed.flagged_before = 1;
  chronicle_ = SessionChronicle{resumed};
  EXPECT_EQ(json::parse(chronicle_.description_line(now_).text).at("stored_before"), 6);
  answer("stew");
  EXPECT_EQ(told_["tally"].at("stored"), 7);
  EXPECT_EQ(told_["tally"].at("flagged"), 1);
  EXPECT_EQ(told_["times"].at("trials_to_come"), 3);
  tell(SessionEnded{.at = now_, .outcome = "stopped"});
  EXPECT_EQ(told_["ended"].at("stored"), 7);
}

TEST_F(SessionChronicleTest, TellsWhatIsNotKnownOfTheSoundAsNull) {
  tell(Health{.at = now_, .refresh_period = 16'666'667ns, .missed_refreshes = 2});
  EXPECT_TRUE(told_.at("health").at("sound_drift_ppm").is_null());
  EXPECT_EQ(told_.at("health").at("missed_refreshes"), 2);
  tell(Health{.at = now_, .sound_drift_ppm = 12.5});
  EXPECT_EQ(told_.at("health").at("sound_drift_ppm"), 12.5);
}

TEST_F(SessionChronicleTest, TellsHowTheSessionEnded) {
  answer("stew");
  tell(SessionEnded{now_, "failed", "the disk is full\nmake room"});
  EXPECT_EQ(told_.at("ended").at("outcome"), "failed");
  EXPECT_EQ(told_.at("ended").at("stored"), 1);
  EXPECT_EQ(told_.at("ended").at("of"), 10);
}

}  // namespace
}  // namespace bimodal::runner

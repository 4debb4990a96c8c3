#include "analysis/data/stored_data.hpp"

#include <gmock/gmock.h>

#include "stimuli/base/error.hpp"
#include "tests/analysis/examples.hpp"

namespace bimodal::analysis {
namespace {

using examples::file;
using examples::session;
using examples::stored_trial;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using namespace std::chrono_literals;

runner::StoredTrial practice(int index) {
  auto trial = stored_trial(index, "bee", "B IY", "bee");
  trial.plan.phase = "practice";
  return trial;
}

std::string refusal(const std::vector<StoredFile>& files, const Selection& selection = {}) {
  try {
    static_cast<void>(gather_trials(files, selection));
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(GatherTrials, LeavesOutPracticeAndCountsIt) {
  const std::vector files{
      file("a", {session("P01", {practice(0), stored_trial(1, "stew", "S T UW", "two")})})};
  const auto dataset = gather_trials(files);
  ASSERT_EQ(dataset.trials.size(), 1U);
  EXPECT_EQ(dataset.trials[0].trial, 1);
  EXPECT_EQ(dataset.stored_trials, 2);
  EXPECT_THAT(dataset.exclusions, ElementsAre(Exclusion{"practice trial", 1}));
  EXPECT_THAT(dataset.warnings, IsEmpty());
}

TEST(GatherTrials, KeepsWhatWasPresentedAndAnswered) {
  const std::vector files{file("a", {session("P01", {stored_trial(0, "stew", "S T UW", " Two")})})};
  const auto trial = gather_trials(files).trials.at(0);
  EXPECT_EQ(trial.participant, "P01");
  EXPECT_EQ(trial.condition, "auditory");
  EXPECT_EQ(trial.auditory_talker, "festival:kal");
  EXPECT_EQ(trial.visual_talker, std::nullopt);
  EXPECT_EQ(trial.snr_db, -8.0);
  EXPECT_EQ(trial.phones, examples::phones("S T UW"));
  EXPECT_EQ(trial.response, " Two");
  EXPECT_EQ(trial.first_key, 500ms);
  EXPECT_EQ(trial.submitted, 1s);
  EXPECT_FALSE(trial.simulated);
}

TEST(GatherTrials, CountsReactionTimesFromThePointThatTheProtocolNames) {
  auto stored = stored_trial(0, "stew", "S T UW", "two");
  stored.trial.response.reference = "sound_onset";
  stored.trial.response.reference_at = stored.trial.stimulus_end - 300ms;
  const std::vector files{file("a", {session("P01", {stored})})};
  const auto trial = gather_trials(files).trials.at(0);
  EXPECT_EQ(trial.first_key, 800ms);
  EXPECT_EQ(trial.submitted, 1'300ms);
}

TEST(GatherTrials, LeavesOutWhatTheProtocolsRuleExcludedAndSaysSo) {
  auto late = stored_trial(0, "stew", "S T UW", "two");
  late.trial.flagged = late.trial.excluded = true;
  auto again = stored_trial(1, "stew", "S T UW", "stew");
  again.plan.repeats = 0;
  const std::vector files{file("a", {session("P01", {late, again})})};
  const auto dataset = gather_trials(files);
  ASSERT_EQ(dataset.trials.size(), 1U);
  EXPECT_EQ(dataset.trials[0].response, "stew");
  EXPECT_THAT(
      dataset.exclusions,
      testing::Contains(Exclusion{"excluded by the protocol's rule: timing not as planned", 1}));
}

TEST(GatherTrials, CountsATrialUnderItsFirstReasonOnly) {
  auto late_practice = practice(0);
  late_practice.trial.flagged = true;
  auto late = stored_trial(1, "stew", "S T UW", "two");
  late.trial.flagged = true;
  const std::vector files{
      file("a", {session("P01", {late_practice, late, stored_trial(2, "bed", "B EH D", "bed")})})};
  const auto dataset = gather_trials(files, {.exclude_flagged = true});
  EXPECT_THAT(
      dataset.exclusions,
      ElementsAre(Exclusion{"practice trial", 1}, Exclusion{"flagged: timing not as planned", 1}));
  EXPECT_EQ(dataset.trials.size(), 1U);
  EXPECT_EQ(gather_trials(files, {.include_practice = true}).trials.size(), 3U);
}

TEST(GatherTrials, LeavesSimulatedAnswersOutWhereAsked) {
  auto simulated = session("P02", {stored_trial(0, "bed", "B EH D", "bed")});
  simulated.session.simulated_answers = true;
  const std::vector files{
      file("a", {session("P01", {stored_trial(0, "bed", "B EH D", "bed")}), simulated})};
  EXPECT_EQ(gather_trials(files, {}).trials.size(), 2U);
  const auto dataset = gather_trials(files, {.exclude_simulated = true});
  ASSERT_EQ(dataset.trials.size(), 1U);
  EXPECT_EQ(dataset.trials[0].participant, "P01");
  EXPECT_THAT(dataset.exclusions,
              ElementsAre(Exclusion{"practice trial", 0}, Exclusion{"simulated answer", 1}));
}

TEST(GatherTrials, SelectsParticipantsAndConditionsAndKnowsWhichThereAre) {
  const std::vector files{file("a", {session("P01", {stored_trial(0, "bed", "B EH D", "bed")})}),
                          file("b", {session("P02", {stored_trial(0, "bed", "B EH D", "bed")})})};
  const auto dataset = gather_trials(files, {.participants = {"P02"}});
  ASSERT_EQ(dataset.trials.size(), 1U);
  EXPECT_EQ(dataset.trials[0].session, 1U);
  EXPECT_THAT(dataset.exclusions, Contains(Exclusion{"participant not selected", 1}));
  EXPECT_EQ(refusal(files, {.participants = {"P03"}}),
            "selecting trials: no participant \"P03\" in the data; there are P01, P02");
  EXPECT_EQ(refusal(files, {.conditions = {"visual"}}),
            "selecting trials: no condition \"visual\" in the data; there is only auditory");
}

TEST(GatherTrials, RefusesASessionThatIsInTwoFiles) {
  const auto twice = session("P01", {stored_trial(0, "bed", "B EH D", "bed")});
  EXPECT_EQ(refusal({file("a", {twice}), file("b", {twice})}),
            "reading 'b': its session 1 (participant P01, started 2026-11-22T10:00:00Z) is also in "
            "'a'; give each session once");
}

TEST(GatherTrials, RefusesPhonesThatAreNone) {
  EXPECT_EQ(refusal({file("a", {session("P01", {stored_trial(4, "bed", "B QQ D", "bed")})})}),
            "reading 'a', session 1, trial 4: \"QQ\" in the phones \"B QQ D\" of \"bed\" is no "
            "phone; the file was not written by this program or has been changed");
}

TEST(GatherTrials, WarnsOfWhatMakesNumbersLessThanTheySeem) {
  auto interrupted = session("P01", {stored_trial(0, "bed", "B EH D", "bed")});
  interrupted.outcome.clear();
  interrupted.planned_trials = 414;
  auto simulated = session(
      "P01", {stored_trial(0, "bed", "B EH D", "bed"), stored_trial(1, "stew", "S T UW", "tw")});
  simulated.session.simulated_answers = true;
  simulated.session.protocol_sha256 = "def";
  simulated.trials[1].plan.snr_db = -4.0;
  simulated.trials[1].trial.flagged = true;
  simulated.trials[1].trial.response.timed_out = true;
  simulated.trials[1].plan.visual_word = "bed";
  const std::vector files{file("a", {interrupted, simulated})};
  EXPECT_THAT(
      gather_trials(files).warnings,
      ElementsAre(HasSubstr("2 different protocols"),
                  HasSubstr("people and simulated sessions are put together"),
                  HasSubstr("share a participant's name and are counted as one participant: P01"),
                  HasSubstr("\"auditory\" has 2 different meanings"),
                  HasSubstr("participant P01 was interrupted: 1 of 414 planned trials"),
                  HasSubstr("1 trial repeats a word"),
                  HasSubstr("1 analysed trial is flagged"),
                  HasSubstr("1 analysed trial is dubbed"),
                  HasSubstr("1 answer was cut off by the time limit")));
}

TEST(GatherTrials, WarnsOfFacesThatWereNotAlike) {
  auto one = session("P01", {stored_trial(0, "bed", "B EH D", "bed")});
  auto other = session("P02", {stored_trial(0, "stew", "S T UW", "stew")});
  one.session.face = runner::FaceDrawingRecord{.quality = "full", .basis = "measured"};
  other.session.face = runner::FaceDrawingRecord{.quality = "full", .basis = "protocol"};
  one.trials[0].plan.face = R"({"view":"front"})";
  EXPECT_THAT(gather_trials(std::vector{file("a", {one, other})}).warnings, IsEmpty());
  other.session.face->quality = "fast";
  other.trials[0].plan.face = R"({"view":"side"})";
  EXPECT_THAT(gather_trials(std::vector{file("a", {one, other})}).warnings,
              ElementsAre(HasSubstr("\"auditory\" looked in 2 ways"),
                          HasSubstr("full quality in 1 session and in fast in 1")));
}

TEST(ReadStoredFiles, RefusesAFileThatIsNotThere) {
  const WrittenFiles folder;
  const std::vector<std::filesystem::path> missing{folder / "none.sqlite"};
  EXPECT_THROW(static_cast<void>(read_stored_files(missing)), Error);
}

}  // namespace
}  // namespace bimodal::analysis

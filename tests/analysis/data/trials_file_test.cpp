#include "analysis/data/trials_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/report/tables.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "tests/analysis/examples.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/fault_of.hpp"

namespace bimodal::analysis {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::string fault_in(std::string_view text, const TrialMapping& mapping = {}) {
  return fault_of([&] { return parse_trials(text, "t.csv", mapping); });
}

/// The trials of a table that names one participant at most.
std::vector<Trial> trials_in(std::string_view text, const TrialMapping& mapping = {}) {
  auto read = parse_trials(text, "t.csv", mapping);
  EXPECT_THAT(read.sessions, SizeIs(1));
  return std::move(read.sessions.front().trials);
}

TEST(TrialsFile, ReadsEveryField) {
  const auto trial = trials_in(
                         "participant,session,trial,phase,block,condition,stimulus,response,phones,"
                         "auditory_talker,visual_talker,snr_db,visual_word,articulation,"
                         "first_key_ms,response_ms,timed_out,flagged,excluded,simulated\n"
                         "P7,2,11,practice,3,bimodal,stew,too,S T UW1,kal,face,-8.5,two,B~W:3/8,"
                         "-20.25,1500,1,no,True,0\n")
                         .front();
  EXPECT_TRUE(trial.timing_known);
  EXPECT_EQ(trial.participant, "P7");
  EXPECT_EQ(trial.trial, 11);
  EXPECT_EQ(trial.phase, "practice");
  EXPECT_EQ(trial.block, 3);
  EXPECT_EQ(trial.condition, "bimodal");
  EXPECT_EQ(trial.word, "stew");
  EXPECT_EQ(trial.response, "too");
  EXPECT_THAT(trial.phones, ElementsAre(Phone::S, Phone::T, Phone::UW));
  EXPECT_EQ(trial.auditory_talker, "kal");
  EXPECT_EQ(trial.visual_talker, "face");
  EXPECT_EQ(trial.snr_db, -8.5);
  EXPECT_EQ(trial.visual_word, "two");
  EXPECT_EQ(trial.articulation, "B~W:3/8");
  EXPECT_EQ(trial.first_key, -20'250us);
  EXPECT_EQ(trial.submitted, 1500ms);
  EXPECT_TRUE(trial.timed_out);
  EXPECT_FALSE(trial.flagged);
  EXPECT_TRUE(trial.excluded);
  EXPECT_FALSE(trial.simulated);
}

TEST(TrialsFile, LeavesAbsentWhatTheTableDoesNotSay) {
  const auto read = parse_trials("stimulus,response\nstew,too\ntwo,\n", "t.csv");
  EXPECT_THAT(read.warnings, ElementsAre(HasSubstr("names no participants")));
  const auto& trials = read.sessions.front().trials;
  ASSERT_THAT(trials, SizeIs(2));
  EXPECT_EQ(trials[1].participant, "1");
  EXPECT_EQ(trials[1].trial, 1);
  EXPECT_EQ(trials[1].phase, "main");
  EXPECT_EQ(trials[1].condition, "all");
  EXPECT_EQ(trials[1].response, "");
  EXPECT_FALSE(trials[1].auditory_talker);
  EXPECT_FALSE(trials[1].snr_db);
  EXPECT_FALSE(trials[1].submitted);
  EXPECT_FALSE(trials[1].timing_known);
  EXPECT_FALSE(read.sessions.front().summary.flagged_trials);
  EXPECT_THAT(trials[1].phones, IsEmpty());
}

TEST(TrialsFile, KnowsOtherNamesOfColumns) {
  const auto trial =
      trials_in("participant,word,response,rt_ms,snr_db\nP1,stew,too,812.5,NA\n").front();
  EXPECT_EQ(trial.word, "stew");
  EXPECT_EQ(trial.submitted, 812'500us);
  EXPECT_FALSE(trial.snr_db);
  EXPECT_EQ(trials_in("participant,word,response,submitted_ms\nP1,a,b,9\n").front().submitted, 9ms);
}

TEST(TrialsFile, KnowsNamesOfColumnsInCapitals) {
  const auto read =
      parse_trials("Subject,Condition,Stimulus,RESPONSE,condition\nS1,A,stew,two,V\n", "t.csv");
  const auto& trial = read.sessions.front().trials.front();
  EXPECT_EQ(trial.participant, "S1");
  EXPECT_EQ(trial.condition, "V");  // as it is spelt, before what is spelt otherwise
  EXPECT_EQ(trial.response, "two");
  EXPECT_EQ(trials_in("Subject,Condition,Stimulus,Response\nS1,A,a,b\n").front().condition, "A");
  EXPECT_TRUE(is_trial_table("Subject,Condition,Stimulus,Response\n"));
}

TEST(TrialsFile, WarnsOfColumnsThatMayBeMisspelt) {
  EXPECT_THAT(
      parse_trials("participant,conditon,stimulus,response,age\nP1,A,a,b,30\n", "t.csv").warnings,
      ElementsAre(HasSubstr("The column \"conditon\" of the table of trials is not read; if it is "
                            "meant to be \"condition\""),
                  HasSubstr("names no conditions: all trials are taken for one condition, \"all\". "
                            "Columns that are not read: \"conditon\", \"age\".")));
  EXPECT_THAT(
      parse_trials("participant,condition,stimulus,response,age\nP1,A,a,b,30\n", "t.csv").warnings,
      IsEmpty());
  EXPECT_THAT(parse_trials("participant,modality,stimulus,response\nP1,A,a,b\n", "t.csv").warnings,
              ElementsAre(HasSubstr("Columns that are not read: \"modality\"")));
  EXPECT_THAT(parse_trials("participant,talker,stimulus,response\nP1,A,a,b\n",
                           "t.csv",
                           {.columns = {{"condition", {"talker"}}}})
                  .warnings,
              IsEmpty());
}

TEST(TrialsFile, TakesWhatTheMappingNames) {
  const TrialMapping mapping{
      .columns = {{"participant", {"Subj"}},
                  {"condition", {"modality", "talker"}},
                  {"stimulus", {"Target"}},
                  {"response", {"Typed"}}},
      .values = {{"condition", {{"V nat", "natural"}}}, {"response", {{"(none)", ""}}}},
      .constants = {{"phase", "practice"}, {"snr_db", "-8"}}};
  const auto trials = trials_in(
      "Subj,modality,talker,Target,Typed,condition\n"
      "S1,V,nat,stew,two,ignored\nS1,V,syn,stew,(none),ignored\n",
      mapping);
  EXPECT_EQ(trials[0].condition, "natural");  // joined, then replaced
  EXPECT_EQ(trials[1].condition, "V syn");
  EXPECT_EQ(trials[1].response, "");
  EXPECT_EQ(trials[1].phase, "practice");
  EXPECT_EQ(trials[1].snr_db, -8.0);
  EXPECT_EQ(fault_in("Subj,Target,Typed\nS1,a,b\n", mapping),
            "t.csv:1: there is no column \"modality\", of which the mapping makes \"condition\"; "
            "the columns are: Subj, Target, Typed");
}

TEST(TrialsFile, ReadsEveryDelimiterAndWhateverSpreadsheetsLeave) {
  for (const std::string_view text :
       {"participant;stimulus;response\nP1;stew;\"a;b\"\n",
        "participant\tstimulus\tresponse\nP1\tstew\t\"a;b\"\n",
        "\xef\xbb\xbfparticipant,stimulus,response\r\nP1,stew,a;b\r\n\r\n"}) {
    EXPECT_EQ(trials_in(text).front().response, "a;b") << text;
  }
  const TrialMapping by_semicolon{.delimiter = ';'};
  EXPECT_EQ(trials_in("\"a, b\";stimulus;response\n1;stew;x\n", by_semicolon).front().word, "stew");
  const auto quoted = trials_in("stimulus,response\nstew,\"two\nlines \"\"here\"\"\"\n");
  EXPECT_EQ(quoted.front().response, "two\nlines \"here\"");
}

/// A syllable, a condition and a participant may be called "NA".
TEST(TrialsFile, TakesNaForAText) {
  const auto trial = trials_in("participant,condition,stimulus,response\nNA,NA,NA,NA\n").front();
  EXPECT_EQ(trial.participant, "NA");
  EXPECT_EQ(trial.condition, "NA");
  EXPECT_EQ(trial.word, "NA");
  EXPECT_EQ(trial.response, "NA");
}

TEST(TrialsFile, MakesASessionOfEachParticipantAndSession) {
  const auto read = parse_trials(
      "participant,session,stimulus,response,flagged\n"
      "B,1,a,a,1\nA,1,a,a,0\nB,2,a,a,0\nB,1,b,b,1\n",
      "t.csv");
  ASSERT_THAT(read.sessions, SizeIs(3));
  const auto& first = read.sessions[0].summary;
  EXPECT_EQ(first.participant, "B");
  EXPECT_EQ(first.participant_number, 1);
  EXPECT_EQ(first.stored_trials, 2);
  EXPECT_EQ(first.flagged_trials, 2);
  EXPECT_EQ(read.sessions[1].summary.participant_number, 2);
  EXPECT_EQ(read.sessions[2].summary.session_number, 2);
  EXPECT_EQ(read.sessions[2].summary.participant_number, 1);
}

TEST(TrialsFile, RefusesWhatItCannotReadAndSaysWhere) {
  EXPECT_THAT(fault_in(""), HasSubstr("the file is empty"));
  EXPECT_THAT(fault_in("stimulus,response\n"), HasSubstr("there are no trials"));
  EXPECT_THAT(fault_in("stimulus,answer\na,b\n"),
              HasSubstr("t.csv:1: there is no column \"response\""));
  EXPECT_THAT(fault_in("stimulus,response\na\n"), HasSubstr("t.csv:2: 1 fields"));
  EXPECT_THAT(fault_in("stimulus,response\na,b\n,b\n"), HasSubstr("t.csv:3: the trial has no"));
  EXPECT_THAT(fault_in("stimulus,response\n\xff,b\n"), HasSubstr("not UTF-8"));
  EXPECT_THAT(fault_in("participant,stimulus,response\nP1,a,b\n,a,b\n"),
              HasSubstr("t.csv:3: the trial has no participant"));
  const auto fault_of_value = [](const std::string& column, const std::string& value) {
    return fault_in("stimulus,response," + column + "\na,\"b\nc\",\na,b," + value + "\n");
  };
  for (const auto* const wrong : {"loud", "-8,5", "1e10", "nan", "3 4", "0x10"}) {
    EXPECT_THAT(fault_of_value("snr_db", "\"" + std::string{wrong} + "\""),
                HasSubstr("t.csv:4: \"" + std::string{wrong} + "\", the snr_db, is no number"));
  }
  EXPECT_THAT(fault_of_value("trial", "1.5"), HasSubstr("t.csv:4: 1.5, the trial, is no whole"));
  EXPECT_THAT(fault_of_value("flagged", "perhaps"),
              HasSubstr("t.csv:4: \"perhaps\", of \"flagged\", says neither yes nor no"));
  EXPECT_THAT(fault_of_value("phones", "S T UX9"),
              HasSubstr("t.csv:4: \"UX9\" among the phones is no phone"));
}

TEST(TrialsFile, IsToldFromAMatrix) {
  EXPECT_TRUE(is_trial_table("participant,word,response\n"));
  EXPECT_TRUE(is_trial_table("stimulus;response\n"));
  EXPECT_TRUE(is_trial_table("condition\tstimulus\tresponse\trt\n"));
  EXPECT_FALSE(is_trial_table("stimulus,p,b\np,1,2\n"));
  EXPECT_FALSE(is_trial_table("condition,stimulus,response,count\n"));
  EXPECT_FALSE(is_trial_table("stimulus,response,n\n"));
  EXPECT_FALSE(is_trial_table(""));
  EXPECT_FALSE(is_trial_table("\"stimulus"));
}

/// Everything that the report's table has a column for.
void expect_alike(const Trial& read, const Trial& written) {
  EXPECT_EQ(read.participant, written.participant);
  EXPECT_EQ(read.trial, written.trial);
  EXPECT_EQ(read.phase, written.phase);
  EXPECT_EQ(read.block, written.block);
  EXPECT_EQ(read.condition, written.condition);
  EXPECT_EQ(read.auditory_talker, written.auditory_talker);
  EXPECT_EQ(read.visual_talker, written.visual_talker);
  EXPECT_EQ(read.snr_db, written.snr_db);
  EXPECT_EQ(read.word, written.word);
  EXPECT_EQ(read.visual_word, written.visual_word);
  EXPECT_EQ(read.articulation, written.articulation);
  EXPECT_EQ(read.phones, written.phones);
  EXPECT_EQ(read.response, written.response);
  EXPECT_EQ(read.first_key, written.first_key);
  EXPECT_EQ(read.submitted, written.submitted);
  EXPECT_EQ(read.timed_out, written.timed_out);
  EXPECT_EQ(read.flagged, written.flagged);
  EXPECT_EQ(read.simulated, written.simulated);
}

TEST(TrialsFile, ReadsWhatTheReportWrote) {
  auto dubbed = examples::stored_trial(3, "bat", "B AE T", "p\"a,\nt");
  dubbed.plan.visual_word = "gat";
  dubbed.plan.visual_talker = "face";
  dubbed.plan.articulation = "B~W:3/8 AE T";
  auto seen = examples::stored_trial(4, "stew", "S T UW", "");
  seen.plan.condition = "visual";
  seen.plan.auditory_talker.reset();
  seen.plan.snr_db.reset();
  seen.plan.block = 2;
  seen.trial.response.first_key.reset();
  seen.trial.response.submitted = 14'123'456'789ns;
  const WrittenFiles folder;
  const auto results =
      analyse(gather_trials(std::vector{examples::file(
                  "a.sqlite",
                  {examples::session("P 1", {dubbed, seen}),
                   examples::session("P2", {examples::stored_trial(0, "two", "T UW", "NA")})})}),
              examples::dictionary(folder),
              {});
  const auto table = report_tables(results, {}).front();
  ASSERT_EQ(table.name, "trials.csv");
  ASSERT_TRUE(is_trial_table(table.content));
  std::vector<TrialsOfFile> files;
  files.push_back(parse_trials(table.content, "trials.csv"));
  EXPECT_THAT(files.front().warnings, IsEmpty());
  const auto again = gather(std::move(files));
  ASSERT_EQ(again.trials.size(), results.dataset.trials.size());
  for (std::size_t i = 0; i < again.trials.size(); ++i) {
    SCOPED_TRACE(i);
    expect_alike(again.trials[i], results.dataset.trials[i]);
  }
}

TEST(TrialsFile, KnowsTheFileByItsContent) {
  const WrittenFiles folder;
  const auto file = folder.write("t.csv", "stimulus,response\na,b\n");
  const auto read = read_trials(file);
  EXPECT_EQ(read.file.name, file.string());
  EXPECT_EQ(read.file.sha256, sha256_of_file(file));
}

TEST(TrialsFile, IsReadOrRefusedWhateverTheBytes) {
  Damage damage{18};
  const std::string good =
      "participant,trial,condition,stimulus,response,snr_db,flagged,phones,response_ms\n"
      "P1,0,a,stew,\"t,oo\",-8,1,S T UW,812.5\nP1,1,a,two,,,0,T UW,\n";
  const TrialMapping mapping{.columns = {{"condition", {"participant", "stimulus"}}},
                             .values = {{"response", {{"NA", ""}}}}};
  for (int round = 0; round < 20'000; ++round) {
    try {
      const auto read =
          parse_trials(damage(good), "t.csv", round % 2 == 0 ? TrialMapping{} : mapping);
      EXPECT_FALSE(read.sessions.empty());
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("t.csv"));
    }
  }
}

}  // namespace
}  // namespace bimodal::analysis

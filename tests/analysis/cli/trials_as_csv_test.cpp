// Verbs on trials that come as CSV: chosen, said and mapped by options, and where they came from.

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/digest.hpp"
#include "tests/analysis/cli/program_run.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::analysis {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using Json = nlohmann::json;

/// Two participants, in a language of three syllables; P2 is never right with the ears.
class TrialsAsCsv : public testing::Test {
 protected:
  [[nodiscard]] ProgramRun run_on(const std::string& file,
                                  std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin() + 1, file);
    arguments.insert(arguments.end(), {"--lexicon", lexicon_});
    return run(arguments);
  }

  [[nodiscard]] ProgramRun run_on_trials(std::vector<std::string> arguments) const {
    return run_on(trials_, std::move(arguments));
  }

  [[nodiscard]] std::vector<std::string> matrix(std::vector<std::string> more) const {
    std::vector<std::string> arguments{
        "matrix", "--unit", "consonant-initial", "--condition", "visual", "--csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  WrittenFiles files_;
  const std::string lexicon_ =
      files_.write("l.csv", "word,phonemes\nNA,N AA\npa,P AA\nba,bɑ\n").string();
  const std::string trials_ = files_
                                  .write("t.csv",
                                         "participant,trial,condition,stimulus,response,rt_ms\n"
                                         "P1,0,auditory,pa,pa,900\n"
                                         "P1,1,auditory,ba,ba,900\n"
                                         "P1,2,visual,pa,ba,900\n"
                                         "P1,3,visual,NA,NA,150\n"
                                         "P1,4,visual,ba,,9000\n"
                                         "P2,0,auditory,pa,ba,900\n"
                                         "P2,1,auditory,ba,pa,900\n"
                                         "P2,2,visual,pa,pa,900\n"
                                         "P2,3,visual,NA,gna,900\n"
                                         "P2,4,visual,ba,pa,900\n")
                                  .string();
};

TEST_F(TrialsAsCsv, AreScoredByTheLexicon) {
  const auto made = run_on_trials(matrix({}));
  EXPECT_EQ(made.code, ExitCode::Done) << made.err;
  EXPECT_EQ(made.out,
            "\"stimulus\",\"P\",\"B\",\"N\",\"deleted\",\"blank\",\"other\"\n"
            "\"P\",1,1,0,0,0,0\n"
            "\"B\",1,0,0,0,1,0\n"
            "\"N\",0,0,1,0,0,1\n");
  EXPECT_EQ(made.err, "Trials: 10 in the data, 10 analysed.\n");
}

TEST_F(TrialsAsCsv, AreLeftOutByResponseTime) {
  const auto made = run_on_trials(matrix({"--fastest", "200", "--slowest", "5000"}));
  EXPECT_EQ(made.out,
            "\"stimulus\",\"P\",\"B\",\"N\",\"deleted\",\"blank\",\"other\"\n"
            "\"P\",1,1,0,0,0,0\n"
            "\"B\",1,0,0,0,0,0\n"
            "\"N\",0,0,0,0,0,1\n");
}

TEST_F(TrialsAsCsv, OfParticipantsBelowACriterionAreLeftOut) {
  const auto made = run_on_trials(matrix({"--at-least", "auditory=0.5"}));
  EXPECT_THAT(made.out, AllOf(HasSubstr("\"P\",0,1,0"), HasSubstr("\"N\",0,0,1,0,0,0\n")));
  const auto all = run_on_trials(matrix({"--at-least", "auditory=0"}));
  EXPECT_EQ(all.out, run_on_trials(matrix({})).out);
  // exactly as good as the criterion is good enough
  EXPECT_EQ(run_on_trials(matrix({"--at-least", "auditory=1"})).out, made.out);
  const auto nobody = run_on_trials(matrix({"--at-least", "visual=0.9"}));
  EXPECT_EQ(nobody.code, ExitCode::Findings);
  EXPECT_THAT(nobody.err, HasSubstr("participant below 0.9 correct in \"visual\" (P1, P2)"));
}

TEST_F(TrialsAsCsv, RefuseACriterionThatIsNone) {
  for (const auto* const wrong : {"auditory", "auditory=", "=0.5", "auditory=1.5", "auditory=x"}) {
    const auto made = run_on_trials(matrix({"--at-least", wrong}));
    EXPECT_EQ(made.code, ExitCode::Usage) << wrong;
    EXPECT_THAT(made.err, HasSubstr("is no criterion; write a condition and a proportion"));
  }
  const auto unknown = run_on_trials(matrix({"--at-least", "tactile=0.5"}));
  EXPECT_EQ(unknown.code, ExitCode::InvalidInput);
  EXPECT_THAT(unknown.err,
              HasSubstr("the data have no condition \"tactile\"; there are auditory, visual"));
}

TEST_F(TrialsAsCsv, SayWhereTheyCameFromAndWhatWasLeftOut) {
  const auto made = run_on_trials({"information",
                                   "--unit",
                                   "vowel",
                                   "--condition",
                                   "visual",
                                   "--fastest",
                                   "200",
                                   "--at-least",
                                   "auditory=0.5",
                                   "--json"});
  ASSERT_EQ(made.code, ExitCode::Done) << made.err;
  const auto data = Json::parse(made.out).at("data");
  ASSERT_THAT(data.at("files"), SizeIs(1));
  EXPECT_EQ(data.at("files").at(0).at("name"), trials_);
  EXPECT_EQ(data.at("files").at(0).at("sha256"), sha256_of_file(trials_));
  EXPECT_EQ(data.at("trials"), 10);
  EXPECT_EQ(data.at("analysed_trials"), 4);
  EXPECT_EQ(data.at("exclusions"), Json::parse(R"json([
    {"reason": "practice trial", "trials": 0},
    {"reason": "answered in less than 200 ms", "trials": 1},
    {"reason": "participant below 0.5 correct in \"auditory\" (P2)", "trials": 5}])json"));
}

TEST_F(TrialsAsCsv, AreReadThroughAMapping) {
  const auto other = files_
                         .write("o.csv",
                                "Subj;modality;face;Target;Typed\n"
                                "S1;V;nat;pa;(none)\nS1;V;nat;ba;ba\nS1;V;syn;pa;NA\n")
                         .string();
  const auto mapping = files_
                           .write("m.json",
                                  R"json({"columns": {"participant": "Subj",
                                      "condition": ["modality", "face"],
                                      "stimulus": "Target", "response": "Typed"},
                          "values": {"condition": {"V nat": "visual"},
                                     "response": {"(none)": ""}}})json")
                           .string();
  const auto made = run_on(other, matrix({"--mapping", mapping}));
  EXPECT_EQ(made.code, ExitCode::Done) << made.err;
  EXPECT_EQ(made.out,
            "\"stimulus\",\"P\",\"B\",\"N\",\"deleted\",\"blank\",\"other\"\n"
            "\"P\",0,0,0,0,1,0\n"
            "\"B\",0,1,0,0,0,0\n");
  const auto unmapped = run_on(other, matrix({}));
  EXPECT_EQ(unmapped.code, ExitCode::InvalidInput);
  const auto wrong = files_.write("w.json", R"({"columns": {"respons": "Typed"}})").string();
  const auto refused = run_on(other, matrix({"--mapping", wrong}));
  EXPECT_EQ(refused.code, ExitCode::InvalidInput);
  EXPECT_THAT(refused.err, HasSubstr("w.json:1: /columns/respons"));
}

TEST_F(TrialsAsCsv, WarnOfStimuliThatNobodyCanSay) {
  const auto strange =
      files_.write("s.csv", "participant,stimulus,response\nP1,pa,pa\nP1,xyzzy,pa\n").string();
  const auto made = run_on(strange, {"information", "--unit", "vowel"});
  EXPECT_THAT(made.err, HasSubstr("1 trial presents a stimulus that no lexicon"));
}

TEST_F(TrialsAsCsv, NeedAUnitAndNoMatrix) {
  const auto without = run_on_trials({"information", "--condition", "visual"});
  EXPECT_EQ(without.code, ExitCode::InvalidInput);
  EXPECT_THAT(without.err, HasSubstr("Give --unit, one of: consonant-initial"));
  const auto broken = files_.write("b.csv", "participant,stimulus,response\nP1,pa\n").string();
  EXPECT_THAT(run_on(broken, {"information", "--unit", "vowel"}).err,
              AllOf(HasSubstr("b.csv:2: 2 fields"), Not(HasSubstr("matrix"))));
}

}  // namespace
}  // namespace bimodal::analysis

#include "analysis/cli/program.hpp"

#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "runner/store/session_store.hpp"
#include "stimuli/base/digest.hpp"
#include "tests/analysis/cli/program_run.hpp"
#include "tests/analysis/examples.hpp"

namespace bimodal::analysis {
namespace {

using examples::stored_trial;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class Program : public testing::Test {
 protected:
  /// A data file with one session, as `bimodal run` would leave it.
  [[nodiscard]] std::string store(const std::string& file,
                                  const std::string& participant,
                                  const std::vector<runner::StoredTrial>& trials) const {
    const auto path = folder_ / file;
    const auto stored = examples::session(participant, trials);
    const auto opened = runner::open_sqlite_store(path);
    std::vector<runner::PlanRecord> plan;
    for (const auto& trial : trials) plan.push_back(trial.plan);
    const auto session = opened->begin(stored.session, plan);
    for (const auto& trial : trials) opened->add(session, trial.trial);
    opened->end(session, "complete", "2026-11-22T11:00:00Z");
    return path.string();
  }

  [[nodiscard]] std::string dictionary() const {
    return folder_.write("words.dict", examples::kDictionaryText).string();
  }

  [[nodiscard]] std::filesystem::path in_folder(std::string_view name) const {
    return folder_ / name;
  }

 private:
  WrittenFiles folder_;
};

TEST_F(Program, PrintsAMatrixOfStoredSessionsAsCsv) {
  const auto data = store("a.sqlite",
                          "P01",
                          {stored_trial(0, "bat", "B AE T", "pat"),
                           stored_trial(1, "red", "R EH D", "read"),
                           stored_trial(2, "bed", "B EH D", " ")});
  const auto printed = run({"matrix",
                            data,
                            "--unit",
                            "consonant-initial",
                            "--condition",
                            "auditory",
                            "--csv",
                            "--dictionary",
                            dictionary()});
  EXPECT_EQ(printed.code, ExitCode::Done);
  EXPECT_EQ(printed.err, "Trials: 3 in the data, 3 analysed.\n");
  EXPECT_EQ(printed.out,
            "\"stimulus\",\"P\",\"B\",\"R\",\"deleted\",\"blank\",\"other\"\n"
            "\"B\",1,0,0,0,1,0\n"
            "\"R\",0,0,1,0,0,0\n");
}

TEST_F(Program, WritesTheReportAndPrintsItsPathLast) {
  const std::vector data{store("a.sqlite", "P01", {stored_trial(0, "bat", "B AE T", "pat")}),
                         store("b.sqlite", "P02", {stored_trial(0, "bat", "B AE T", "bat")})};
  const auto folder = in_folder("deep/report");
  const auto made =
      run({"report", data[0], data[1], "-o", folder.string(), "--dictionary", dictionary()});
  EXPECT_EQ(made.code, ExitCode::Done) << made.err;
  EXPECT_EQ(made.out, (folder / "report.html").string() + "\n");
  const auto page = read_file(folder / "report.html");
  EXPECT_THAT(page, HasSubstr(sha256_of_file(data[1])));
  EXPECT_THAT(page, HasSubstr("2 participants, 2 trials in 1 condition"));
  EXPECT_THAT(read_file(folder / "confusions.csv"), HasSubstr("\"B\",\"P\",1,2,0.5"));
  EXPECT_TRUE(read_file(folder / "report.pdf").starts_with("%PDF"));
  for (const auto* const figure : {"words", "vowel-auditory"}) {
    for (const auto* const width : {"-85mm", "-174mm"}) {
      const auto name = folder / "figures" / (std::string{figure} + width);
      EXPECT_THAT(read_file(name.string() + ".svg"), HasSubstr("<text"));
      EXPECT_TRUE(read_file(name.string() + ".pdf").starts_with("%PDF"));
    }
  }
}

TEST_F(Program, ScoresTheAnswersOfStoredSessions) {
  const std::vector data{store("a.sqlite",
                               "P01",
                               {stored_trial(0, "bat", "B AE T", "bats"),
                                stored_trial(1, "two", "T UW", "too"),
                                stored_trial(2, "stew", "S T UW", "bee")}),
                         store("b.sqlite", "P02", {stored_trial(0, "bat", "B AE T", "")})};
  const auto score = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"score", data[0], data[1], "--dictionary", dictionary()});
    return run(options);
  };
  const auto plain = score({});
  EXPECT_EQ(plain.code, ExitCode::Done) << plain.err;
  EXPECT_THAT(plain.out, HasSubstr("Tolerated: nothing."));
  const auto usual = nlohmann::json::parse(score({"--json"}).out)["conditions"][0];
  EXPECT_EQ(usual["n"], 4);
  EXPECT_EQ(usual["homophone"], 1);
  EXPECT_EQ(usual["out_of_dictionary"], 1);
  EXPECT_EQ(usual["omissions"], 1);
  const auto chosen = nlohmann::json::parse(
      score({"--json", "--by-participant", "--tolerate", "tense,plural", "--no-homophones"}).out);
  EXPECT_EQ(chosen["rules"]["tolerate"], nlohmann::json::array({"plural", "tense"}));
  EXPECT_EQ(chosen["conditions"][0]["tolerated"], 1);
  EXPECT_EQ(chosen["conditions"][0]["homophone"], 0);
  EXPECT_EQ(chosen["participants"][1]["omissions"], 1);
  const auto repeated =
      score({"--tolerate", "plural", "--tolerate", "numbers", "--csv", "--by-participant"});
  EXPECT_THAT(repeated.out, HasSubstr("\n\"auditory\",\"P01\",3,0,1,1,1,0,0,"));
  EXPECT_THAT(score({"--trials", "--out-of-dictionary", "letter-to-sound"}).out,
              HasSubstr("not in dictionary\t\t0\tB AE T\tB AE T S\tB>B AE>AE T>T\t3\t3\t1\n"));
  EXPECT_THAT(score({"--trials", "--costs", "feature", "--csv"}).out,
              HasSubstr("\"S>deleted T>B UW>IY\""));
  EXPECT_EQ(score({"--tolerate", "everything"}).code, ExitCode::Usage);
  EXPECT_EQ(score({"--ties", "first"}).code, ExitCode::Usage);
  EXPECT_EQ(score({"--trials", "--by-participant"}).code, ExitCode::Usage);
}

TEST_F(Program, PrintsMatricesOfClustersPhonemesAndWords) {
  const auto data =
      store("a.sqlite",
            "P01",
            {stored_trial(0, "stew", "S T UW", "bee"), stored_trial(1, "bat", "B AE T", "pat")});
  const auto matrix = [&](const std::string& unit, const std::vector<std::string>& options) {
    std::vector<std::string> all{
        "matrix", data, "--unit", unit, "--csv", "--dictionary", dictionary()};
    all.insert(all.end(), options.begin(), options.end());
    return run(all).out;
  };
  EXPECT_EQ(matrix("onset", {}),
            "\"stimulus\",\"P\",\"B\",\"S T\",\"blank\",\"other\"\n"
            "\"B\",1,0,0,0,0\n"
            "\"S T\",0,1,0,0,0\n");
  EXPECT_THAT(matrix("coda", {}), HasSubstr("\"none\",1,0,0,0\n"));
  EXPECT_THAT(matrix("phoneme", {"--ties", "average"}), HasSubstr("\n\"S\",0,0.5,0,"));
  EXPECT_THAT(matrix("word", {}), HasSubstr("\n\"bat\",0,0,1,0,0\n"));
}

TEST_F(Program, SaysInTheReportByWhichRulesAnswersWereScored) {
  const auto data = store("a.sqlite", "P01", {stored_trial(0, "bat", "B AE T", "bats")});
  const auto folder = in_folder("report");
  const auto report = [&](std::vector<std::string> options) {
    options.insert(options.begin(),
                   {"report", data, "-o", folder.string(), "--dictionary", dictionary()});
    EXPECT_EQ(run(options).code, ExitCode::Done);
    return read_file(folder / "report.html");
  };
  EXPECT_THAT(report({}), testing::Not(HasSubstr("Tolerated</th>")));
  const auto page = report({"--tolerate", "plural"});
  EXPECT_THAT(page, HasSubstr("Tolerated: plural."));
  EXPECT_THAT(page, HasSubstr("<th scope='col' class='number'>Tolerated</th>"));
  EXPECT_THAT(page, HasSubstr("(homophone); tolerated besides: plural. An answer"));
  EXPECT_THAT(page, HasSubstr("insertion cost 1 each, vowels stand"));
  const auto other = report({"--no-homophones", "--ties", "average", "--costs", "feature"});
  EXPECT_THAT(other, HasSubstr("word; homophones are wrong. An answer"));
  EXPECT_THAT(other, HasSubstr("substitution costs the share of phonetic features"));
  EXPECT_THAT(other, HasSubstr("equally good alignments weigh the same, so that"));
  EXPECT_THAT(other, testing::Not(HasSubstr("is <i>ambiguous</i>")));
}

TEST_F(Program, SaysWhyThereIsNothingToAnalyse) {
  auto practice = stored_trial(0, "bat", "B AE T", "pat");
  practice.plan.phase = "practice";
  const auto data = store("a.sqlite", "P01", {practice});
  const auto made =
      run({"report", data, "-o", in_folder("report").string(), "--dictionary", dictionary()});
  EXPECT_EQ(made.code, ExitCode::Findings);
  EXPECT_EQ(made.err,
            "bimodal-analysis: no trial left to analyse: 1 stored in 1 session, left out: 1 x "
            "practice trial; check the selection (--include-practice counts practice trials)\n");
  EXPECT_FALSE(std::filesystem::exists(in_folder("report")));
}

TEST_F(Program, SuggestsTheOptionThatWasMeant) {
  const auto made = run({"score", "a.csv", "--lexikon=l.csv"});
  EXPECT_EQ(made.code, ExitCode::Usage);
  EXPECT_THAT(made.err, HasSubstr("did you mean --lexicon instead of --lexikon?"));
  EXPECT_THAT(run({"score", "a.csv", "--frobnicate"}).err, testing::Not(HasSubstr("did you mean")));
}

TEST_F(Program, NamesTheConditionsThatThereAre) {
  auto other = stored_trial(1, "bat", "B AE T", "pat");
  other.plan.condition = "visual";
  const auto data = store("a.sqlite", "P01", {stored_trial(0, "bat", "B AE T", "pat"), other});
  const auto ambiguous = run({"matrix", data, "--unit", "vowel", "--dictionary", dictionary()});
  EXPECT_EQ(ambiguous.code, ExitCode::InvalidInput);
  EXPECT_EQ(
      ambiguous.err,
      "bimodal-analysis: choosing a confusion matrix: the data have several conditions; choose "
      "with --condition one of: auditory, visual\n");
  const auto unknown =
      run({"matrix", data, "--unit", "vowel", "--condition", "av", "--dictionary", dictionary()});
  EXPECT_EQ(unknown.code, ExitCode::InvalidInput);
  EXPECT_THAT(unknown.err, HasSubstr("the data have no condition \"av\""));
}

TEST_F(Program, RefusesTheSameFileTwice) {
  const auto data = store("a.sqlite", "P01", {stored_trial(0, "bat", "B AE T", "pat")});
  const auto copy = in_folder("copy.sqlite");
  std::filesystem::copy_file(data, copy);
  const auto made = run({"matrix", data, copy.string(), "--unit", "vowel"});
  EXPECT_EQ(made.code, ExitCode::InvalidInput);
  EXPECT_EQ(made.err,
            "bimodal-analysis: reading '" + copy.string() + "': it has the same content as '" +
                data + "'; give each file once\n");
}

TEST_F(Program, ExitsAsItsHelpSays) {
  EXPECT_EQ(run({"--help"}).code, ExitCode::Done);
  EXPECT_THAT(run({"matrix", "--help"}).out, HasSubstr("Examples:"));
  EXPECT_THAT(run({"report", "--help"}).out, HasSubstr("Examples:"));
  EXPECT_THAT(run({"--version"}).out, StartsWith("bimodal-analysis "));
  EXPECT_EQ(run({}).code, ExitCode::Usage);
  EXPECT_EQ(run({"matrix", "x.sqlite", "--unit", "consonant"}).code, ExitCode::Usage);
  EXPECT_EQ(run({"matrix", "no-such.sqlite", "--unit", "vowel"}).code, ExitCode::InvalidInput);
}

TEST_F(Program, CallsAFileThatIsNoStoreAStoreError) {
  const WrittenFiles folder;
  const auto file = folder.write("text.sqlite", "this is no database at all");
  EXPECT_EQ(run({"matrix", file.string(), "--unit", "vowel"}).code, ExitCode::Store);
}

TEST_F(Program, RefusesAnAttachmentThatNoBrowserShows) {
  const WrittenFiles folder;
  const auto file = folder.write("a:b.txt", "text");
  const auto made = run(
      {"report", "x.sqlite", "-o", "nowhere", "--attach-picture", file.string() + ":a: caption"});
  EXPECT_EQ(made.code, ExitCode::InvalidInput);
  EXPECT_EQ(made.err,
            "bimodal-analysis: attaching '" + file.string() +
                "' to the report: it is no PNG or JPEG picture; convert it\n");
}

}  // namespace
}  // namespace bimodal::analysis

// From text to articulation on the command line: tracks, figures, segments, continuum.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/command_line.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class SpeechVerbs : public CommandLine {
 protected:
  [[nodiscard]] std::string written(const std::string& name, const std::string& content) const {
    files_.write(name, content);
    return path(name);
  }
};

TEST_F(SpeechVerbs, TracksOfAScoreAreATable) {
  const auto score = written("score.json",
                             R"({"segments":[{"symbol":"1","duration_ms":100,"controls":{"p":
      {"target":0.1,"theta_before_per_ms":0.035,"theta_after_per_ms":0.035}}},
      {"symbol":"2","duration_ms":100,"controls":{"p":
      {"target":0.9,"theta_before_per_ms":0.035,"theta_after_per_ms":0.035}}}]})");
  EXPECT_THAT(bimodal({"tracks", score, "--rate-hz", "10", "--dominance"}),
              ended(ExitCode::Done, StartsWith("time_ms,p,p@0,p@1\n0,0.12344978460108504,")));
}

TEST_F(SpeechVerbs, TracksOfTextGoByDictionaryRulesOrTypedPhones) {
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{"stew"},
                                             {"stew", "--method", "nrl"},
                                             {"S T UW", "--from", "arpabet"},
                                             {"stu", "--from", "ipa"}}) {
    std::vector<std::string> all{"tracks", "--rate-hz", "20", "--controls", "lip_protrusion"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    EXPECT_THAT(bimodal(all), ended(ExitCode::Done, StartsWith("time_ms,lip_protrusion\n0,")))
        << arguments.front();
  }
}

TEST_F(SpeechVerbs, TracksSayWhatIsWrong) {
  EXPECT_THAT(bimodal({"tracks", "S Q", "--from", "arpabet"}),
              ended(ExitCode::InvalidInput, HasSubstr("\"Q\" is not a phone")));
  EXPECT_THAT(bimodal({"tracks", "stew", "--controls", "jow"}),
              ended(ExitCode::InvalidInput, HasSubstr("did you mean 'jaw'")));
  EXPECT_THAT(bimodal({"tracks", "stew", "--segments", "klingon"}),
              ended(ExitCode::InvalidInput, HasSubstr("turkish-plateau")));
  EXPECT_THAT(bimodal({"tracks", path("none.json")}),
              ended(ExitCode::InvalidInput, HasSubstr("none.json")));
  EXPECT_THAT(bimodal({"tracks", "stew", "--rate", "5"}),
              ended(ExitCode::Usage, HasSubstr("--rate")));
  EXPECT_THAT(bimodal({"tracks", "stew", "--rate", "nan"}),
              ended(ExitCode::Usage, HasSubstr("'nan' is not a number")));
  EXPECT_THAT(bimodal({"tracks", "stew", "--rate-hz", "nan"}),
              ended(ExitCode::Usage, HasSubstr("--rate-hz")));
  EXPECT_THAT(bimodal({"tracks", "stew", "-o", path("x.doc")}),
              ended(ExitCode::InvalidInput, HasSubstr(".svg")));
  EXPECT_THAT(bimodal({"tracks", ""}), ended(ExitCode::InvalidInput, HasSubstr("no words")));
}

TEST_F(SpeechVerbs, TracksRefuseOptionsWithoutEffectAndFilesThatAreNoScores) {
  const auto score = written("score.json", R"({"segments":[{"symbol":"S","duration_ms":100}]})");
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{score, "--from", "text"},
                                             {score, "--method", "nrl"},
                                             {score, "--voice", "kal"},
                                             {"S T UW", "--from", "arpabet", "--method", "nrl"},
                                             {"stew", "--voice", "slt"}}) {
    std::vector<std::string> all{"tracks"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    EXPECT_THAT(bimodal(all), ended(ExitCode::InvalidInput, HasSubstr("has no effect")))
        << arguments[1];
  }
  EXPECT_THAT(bimodal({"tracks", path("")}),
              ended(ExitCode::InvalidInput, HasSubstr("the name of a score ends with .json")));
}

TEST_F(SpeechVerbs, TracksAreOfTheFormThatIsAskedFor) {
  EXPECT_THAT(bimodal({"tracks", "stew", "--svg", "-o", path("x.png")}),
              ended(ExitCode::InvalidInput, HasSubstr("end it with .svg")));
  EXPECT_THAT(bimodal({"tracks", "stew", "--csv", "-o", path("x.txt")}),
              ended(ExitCode::Done, HasSubstr("x.txt")));
}

TEST_F(SpeechVerbs, AContinuumRemovesOnlyWhatAContinuumWrote) {
  const auto folder = path("mine");
  std::filesystem::create_directory(folder);
  files_.write("mine/tokens.json", "{}");
  files_.write("mine/token9.csv", "mine");
  const std::vector<std::string> along{"continuum",
                                       "b",
                                       "--vary",
                                       "cheek_puff",
                                       "--steps",
                                       "2",
                                       "--no-video",
                                       "--height",
                                       "96",
                                       "-o",
                                       folder};
  ASSERT_THAT(bimodal(along), ended(ExitCode::Done, HasSubstr("2 tokens")));
  EXPECT_TRUE(std::filesystem::exists(folder + "/token9.csv"));
  ASSERT_THAT(bimodal(along), ended(ExitCode::Done, HasSubstr("2 tokens")));
  EXPECT_FALSE(std::filesystem::exists(folder + "/token9.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder + "/tokens.json"));
}

TEST_F(SpeechVerbs, WhatTracksWriteAsJsonIsAScore) {
  ASSERT_THAT(bimodal({"tracks", "stew", "--rate-hz", "10", "-o", path("stew.json")}),
              ended(ExitCode::Done, HasSubstr("stew.json")));
  ASSERT_THAT(bimodal({"tracks", "stew", "--rate-hz", "10", "-o", path("stew.csv")}),
              ended(ExitCode::Done, HasSubstr("stew.csv")));
  ASSERT_THAT(bimodal({"tracks",
                       path("stew.json"),
                       "--rate-hz",
                       "10",
                       "--controls",
                       "jaw",
                       "-o",
                       path("2.csv")}),
              ended(ExitCode::Done, HasSubstr("1 controls")));
  ASSERT_THAT(
      bimodal({"tracks", "stew", "--rate-hz", "10", "--controls", "jaw", "-o", path("1.csv")}),
      ended(ExitCode::Done, HasSubstr("1 controls")));
  EXPECT_EQ(bytes("1.csv"), bytes("2.csv"));
}

TEST_F(SpeechVerbs, FiguresOfThePaperAreTenDocuments) {
  EXPECT_THAT(bimodal({"figures", "-o", path("figures")}),
              ended(ExitCode::Done, HasSubstr("figure11.svg")));
  EXPECT_THAT(bytes("figures/figure8.svg"), HasSubstr("<title>Figure 8."));
}

TEST_F(SpeechVerbs, SegmentsAreCheckedAndShown) {
  EXPECT_THAT(
      bimodal({"segments", "check", "--quick"}),
      ended(ExitCode::Done,
            AllOf(HasSubstr("every segment sets every control"), HasSubstr("chosen by us"))));
  EXPECT_THAT(bimodal({"segments", "show", "UW", "-o", path("uw.svg")}),
              ended(ExitCode::Done, HasSubstr("lip_protrusion")));
  EXPECT_TRUE(std::filesystem::exists(path("uw.svg")));
  EXPECT_THAT(bimodal({"segments", "show", "Q"}),
              ended(ExitCode::InvalidInput, HasSubstr("\"Q\" is not a phone")));
  const auto bad =
      written("bad.json", R"({"extends": "english.json", "sources": {}, "groups": 3})");
  EXPECT_THAT(bimodal({"segments", "check", bad}),
              ended(ExitCode::InvalidInput, HasSubstr("bad.json:1: \"groups\" is not an object")));
}

TEST_F(SpeechVerbs, AContinuumHasTokensTablePlotsAndPictures) {
  EXPECT_THAT(bimodal({"continuum", "b", "w", "--steps", "3", "--height", "96", "-o", path("bw")}),
              ended(ExitCode::Done, HasSubstr("B~W:1/2")));
  for (const auto* const name :
       {"tokens.csv", "controls.svg", "movements.svg", "strip.png", "token0.csv", "token2.mp4"}) {
    EXPECT_TRUE(std::filesystem::exists(path("bw") + "/" + name)) << name;
  }
  EXPECT_THAT(bytes("bw/tokens.json"), HasSubstr("\"word\": \"b~w:1/2\""));
  EXPECT_THAT(bimodal({"continuum", "b", "w", "--high", "2", "-o", path("none")}),
              ended(ExitCode::InvalidInput, HasSubstr("values of --vary")));
  EXPECT_THAT(bimodal({"continuum", "b", "--steps", "3", "-o", path("none")}),
              ended(ExitCode::InvalidInput, HasSubstr("--vary")));
  EXPECT_THAT(bimodal({"continuum", "b", "w", "--in", "AA", "-o", path("none")}),
              ended(ExitCode::InvalidInput, HasSubstr("\"_\"")));
}

/// A column of a table of numbers.
std::vector<double> column(const std::string& csv, const std::string& name) {
  std::istringstream lines{csv};
  std::string line;
  std::getline(lines, line);
  const auto fields = [](const std::string& text) {
    std::vector<std::string> found;
    std::istringstream parts{text};
    for (std::string field; std::getline(parts, field, ',');) found.push_back(field);
    return found;
  };
  const auto names = fields(line);
  const auto at = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  std::vector<double> values;
  while (std::getline(lines, line)) values.push_back(std::stod(fields(line).at(at)));
  return values;
}

TEST_F(SpeechVerbs, AContinuumOfTheReleasePartsTheLipsEarlierAndMoreSlowly) {
  ASSERT_THAT(bimodal({"continuum",
                       "b",
                       "--vary",
                       "lip_closure.theta_after,lip_compression.theta_after",
                       "--low",
                       "0.025",
                       "--high",
                       "0.08",
                       "--in",
                       "AA _ AA",
                       "--steps",
                       "4",
                       "--no-video",
                       "--height",
                       "96",
                       "-o",
                       path("speed")}),
              ended(ExitCode::Done, HasSubstr("4 tokens")));
  const auto table = bytes("speed/tokens.csv");
  const auto fastest = column(table, "fastest_opening_mm_per_s");
  const auto shut = column(table, "lips_shut_ms");
  ASSERT_EQ(fastest.size(), 4U);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_LT(fastest[i], fastest[i - 1]);
    EXPECT_LT(shut[i], shut[i - 1]);
  }
  EXPECT_GT(shut.back(), 17);
}

TEST_F(SpeechVerbs, AContinuumTellsWhatTheFaceCannotShow) {
  EXPECT_THAT(bimodal({"continuum",
                       "b",
                       "--vary",
                       "cheek_puff",
                       "--high",
                       "3",
                       "--steps",
                       "2",
                       "--no-video",
                       "--height",
                       "96",
                       "-o",
                       path("puffed")}),
              ended(ExitCode::Done, HasSubstr("cheek_puff goes from")));
}

TEST_F(SpeechVerbs, OutputThatCannotBeWrittenIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const std::string bin{BIMODAL_BIN};
  for (const auto* const what : {"tracks stew", "phones stew", "--help"}) {
    const auto command = "( " + bin + "/bimodal " + what + " > /dev/full ) 2> " + path("errors");
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), static_cast<int>(ExitCode::InvalidInput)) << what;
    EXPECT_THAT(bytes("errors"), HasSubstr("standard output cannot be written")) << what;
  }
}

}  // namespace
}  // namespace bimodal

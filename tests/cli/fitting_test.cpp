// Segments are learnt from tracks, and lips are compared with measured ones.

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/cli/command_line.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kLabels =
    "tier,start_s,end_s,text\nphones,0.3,0.4,B\nphones,0.4,0.6,IY\nphones,0.6,0.7,W\n"
    "phones,0.7,0.9,AA\nphones,0.9,1,B\nphones,1,1.2,UW\nphones,1.2,1.6,\n";

/// Lips that open in vowels and shut in B, every 20 ms; `factor` is the talker's.
std::string track(double factor) {
  std::string text = "time_ms,inner_h,outer_w\n";
  for (int time = 0; time <= 1'600; time += 20) {
    const auto near = [&](double centre, double width) {
      return std::exp(-std::abs(time - centre) / width);
    };
    const double height = 3 + 8 * near(500, 60) + 10 * near(800, 60) + 3 * near(1'100, 60) -
                          9 * near(350, 40) - 9 * near(950, 40) - 3 * near(650, 60);
    const double width = 50 - 4 * near(650, 80) - 5 * near(1'100, 90);
    text += fmt::format("{},{:.3f},{:.3f}\n", time, factor * std::max(0.0, height), width);
  }
  return text;
}

class FitSegments : public CommandLine {
 protected:
  FitSegments() {
    for (const int talker : {1, 2, 3}) {
      files_.write(fmt::format("t{}.csv", talker), track(1.0 + 0.1 * talker));
      files_.write(fmt::format("labels/t{}.labels.csv", talker), kLabels);
      files_.write(fmt::format("lips/t{}.csv", talker), track(1.0 + 0.1 * talker));
    }
  }

  [[nodiscard]] Ended fit(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"fit-segments"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return bimodal(arguments);
  }
};

TEST_F(FitSegments, PrintsAndWritesWhatItLearnt) {
  EXPECT_THAT(
      fit({"t1.csv", "t2.csv", "t3.csv", "--labels", "labels", "-o", "out.json"}),
      ended(ExitCode::Done,
            AllOf(ContainsRegex("inner_h: 3 clips, 1[0-9]+ instants; shrinkage 0.5; fitted"),
                  ContainsRegex("UW +UW +3 "),
                  HasSubstr("outer_w: 3 clips"),
                  HasSubstr("relative to the talker's mean"),
                  HasSubstr("out.json: 2 measures written"))));
  const auto read = nlohmann::json::parse(bytes("out.json"));
  EXPECT_LT(read["definitions"]["B"]["inner_h"]["target"], 1);
  EXPECT_GT(read["definitions"]["AA"]["inner_h"]["target"], 5);
  EXPECT_LT(read["definitions"]["W"]["outer_w"]["target"],
            read["definitions"]["IY"]["outer_w"]["target"]);
  EXPECT_TRUE(read["definitions"].contains("rest"));
  EXPECT_FALSE(read["definitions"].contains("S"));
}

TEST_F(FitSegments, TakesOfAFolderTheTablesThatHaveLabels) {
  files_.write("lips/clips.csv", "clip,talker\n1,2\n");
  EXPECT_THAT(fit({"lips", "--labels", "labels"}), ended(ExitCode::Done, HasSubstr("3 clips")));
  EXPECT_THAT(fit({"labels", "--labels", "labels"}),
              ended(ExitCode::InvalidInput, HasSubstr("no table (.csv) with labels")));
}

TEST_F(FitSegments, TellsClipsThatWereLeftOut) {
  EXPECT_THAT(fit({"t1.csv",
                   "t2.csv",
                   "t3.csv",
                   "--labels",
                   "labels",
                   "--columns",
                   "inner_h",
                   "--leave-one-out",
                   "--theta",
                   "0.02"}),
              ended(ExitCode::Done,
                    AllOf(HasSubstr("left-out RMSE"),
                          ContainsRegex("left-out RMSE [0-9.]+, scaled [0-9.]+, r (0.9|1.0)"),
                          HasSubstr("0.0200  0.0200"),
                          Not(HasSubstr("outer_w")))));
  EXPECT_THAT(fit({"t1.csv", "--labels", "labels/t1.labels.csv", "--leave-one-out"}),
              ended(ExitCode::InvalidInput, HasSubstr("three clips or more, and here are 1")));
}

TEST_F(FitSegments, WarnsOfSegmentsWithOneToken) {
  EXPECT_THAT(fit({"t1.csv", "--labels", "labels/t1.labels.csv", "--same-talker"}),
              ended(ExitCode::Findings, HasSubstr("of W, IY, AA, UW there is one token")));
}

TEST_F(FitSegments, TellsWhatIsWrongWithTracksAndLabels) {
  files_.write("bad.csv", "time_ms,inner_h\n0,1\n20,nan\n20,3\n");
  files_.write("labels/bad.labels.csv", kLabels);
  EXPECT_THAT(
      fit({"bad.csv", "--labels", "labels"}),
      ended(ExitCode::InvalidInput,
            AllOf(HasSubstr("bad.csv:3: inner_h \"nan\""), HasSubstr("bad.csv:4: the time"))));
  EXPECT_THAT(fit({"t1.csv", "t7.csv", "--labels", "labels", "gone.lab"}),
              ended(ExitCode::InvalidInput,
                    AllOf(HasSubstr("t7.csv: there is no such file"), HasSubstr("gone.lab"))));
  EXPECT_THAT(fit({"t1.csv", "lips/t1.csv", "--labels", "labels"}),
              ended(ExitCode::InvalidInput, HasSubstr("a recording of this name, t1.csv")));
  EXPECT_THAT(fit({"t1.csv", "--labels", "labels", "--columns", "jaw"}),
              ended(ExitCode::InvalidInput,
                    AllOf(HasSubstr("no column \"jaw\""), HasSubstr("time_ms, inner_h, outer_w"))));
  EXPECT_THAT(fit({"t1.csv", "two.json", "--labels", "labels"}),
              ended(ExitCode::InvalidInput, HasSubstr("two.json: there are no labels")));
  files_.write("words.csv", "tier,start_s,end_s,text\nwords,0.3,0.6,bee\n");
  EXPECT_THAT(
      fit({"t1.csv", "--labels", "words.csv"}),
      ended(ExitCode::InvalidInput,
            AllOf(HasSubstr("words.csv: no tier is named \"phones\""), HasSubstr("\"words\""))));
  files_.write("late.csv", "tier,start_s,end_s,text\nphones,5,6,B\n");
  EXPECT_THAT(
      fit({"t1.csv", "--labels", "late.csv"}),
      ended(ExitCode::InvalidInput,
            AllOf(HasSubstr("t1.csv"), HasSubstr("late.csv"), HasSubstr("5.000 to 6.000"))));
  files_.write("cat.csv", "tier,start_s,end_s,text\nphones,0.3,0.6,cat\n");
  EXPECT_THAT(fit({"t1.csv", "--labels", "cat.csv"}),
              ended(ExitCode::InvalidInput, HasSubstr("cat.csv")));
  EXPECT_THAT(fit({"t1.csv", "--labels", "labels", "--openings", "jaw"}),
              ended(ExitCode::InvalidInput, HasSubstr("--openings: \"jaw\" is not fitted")));
}

TEST_F(FitSegments, WrongUsageEndsWithTwo) {
  EXPECT_THAT(fit({"t1.csv"}), ended(ExitCode::Usage, HasSubstr("--labels")));
  EXPECT_THAT(fit({"t1.csv", "--labels", "labels", "--theta", "fast"}),
              ended(ExitCode::Usage, HasSubstr("\"fast\" is no theta")));
  EXPECT_THAT(fit({"t1.csv", "--labels", "labels", "-o", "gone/out.json"}),
              ended(ExitCode::Usage, HasSubstr("there is no folder")));
  EXPECT_THAT(fit({"t1.csv", "--labels", "labels", "--theta", "-0.02"}),
              ended(ExitCode::Usage, HasSubstr("--theta")));
}

class ValidateLips : public FitSegments {
 protected:
  ValidateLips() {
    for (const int talker : {1, 2, 3}) {
      EXPECT_EQ(bimodal({"labels",
                         fmt::format("labels/t{}.labels.csv", talker),
                         "-o",
                         fmt::format("lips/t{}.TextGrid", talker)})
                    .exit_code,
                0);
      files_.write(fmt::format("other/t{}.csv", talker), track(2.0));
    }
  }
};

TEST_F(ValidateLips, ComparesTheFaceWithMeasuredLips) {
  EXPECT_THAT(bimodal({"validate-lips", "lips", "--clips", "t1,t3", "-o", "report.csv"}),
              ended(ExitCode::Done,
                    AllOf(ContainsRegex("inner_h +t1 +[0-9]+ +0\\.[5-9]"),
                          ContainsRegex("outer_w +all"),
                          HasSubstr("measured 4 of 4, predicted 4 of 4"),
                          ContainsRegex("UW +2 "),
                          HasSubstr("report.csv: 2 clips compared"))));
  EXPECT_THAT(
      bytes("report.csv"),
      AllOf(
          HasSubstr("clip,phone,measure,quantity,n,value\n"),
          HasSubstr("t3,,inner_h,rmse_scaled,"),
          // The face's lips are shut before a B that begins the sentence: that closure has no time.
          ContainsRegex(
              "all,P B M,inner_h,.lowest, from the centre: difference median, ms.,[24],")));
}

/// The value of a line that begins so, in a report of validate-lips.
double value_of(const std::string& report, const std::string& line) {
  const auto at = report.find(line);
  if (at == std::string::npos) return std::numeric_limits<double>::quiet_NaN();
  return std::strtod(report.c_str() + report.find(',', at + line.size()) + 1, nullptr);
}

TEST_F(ValidateLips, FindsTheFaceLikeNaturalTalkers) {
  const char* const data = std::getenv("BIMODAL_TEST_DATA");
  const auto clips = std::filesystem::path{data == nullptr ? "" : data} / "lips";
  if (!std::filesystem::exists(clips / "bbaf2n.csv")) {
    GTEST_SKIP() << "BIMODAL_TEST_DATA does not name a folder with lips/bbaf2n.csv";
  }
  EXPECT_THAT(bimodal({"validate-lips", clips.string(), "-o", "report.csv"}),
              ended(ExitCode::Done, HasSubstr("measured 9 of 9, predicted 9 of 9")));
  const auto report = bytes("report.csv");
  EXPECT_GE(value_of(report, "all,,inner_h,r,"), 0.84);
  EXPECT_GE(value_of(report, "all,,outer_w,r,"), 0.64);
}

TEST_F(ValidateLips, ComparesTheTracksOfAnyTalkingHead) {
  EXPECT_THAT(bimodal({"validate-lips", "lips", "--tracks", "other"}),
              ended(ExitCode::Done,
                    AllOf(ContainsRegex("inner_h +all +[0-9]+ +1\\.00 +[0-9.]+ +0\\.00 +0\\.60"),
                          ContainsRegex("lowest, from the centre.* 0 .SD 0, n 6"))));
}

TEST_F(ValidateLips, TellsWhatIsMissing) {
  EXPECT_THAT(bimodal({"validate-lips", "nowhere"}),
              ended(ExitCode::InvalidInput, HasSubstr("'nowhere' is no folder")));
  EXPECT_THAT(bimodal({"validate-lips", "labels"}),
              ended(ExitCode::InvalidInput, HasSubstr("has no CLIP.csv with a CLIP.TextGrid")));
  EXPECT_THAT(bimodal({"validate-lips", "lips", "--clips", "t9"}),
              ended(ExitCode::InvalidInput, HasSubstr("t9")));
  EXPECT_THAT(bimodal({"validate-lips", "lips", "--tracks", "labels"}),
              ended(ExitCode::InvalidInput, HasSubstr("labels/t1.csv")));
  files_.write("short/t1.csv", "time_ms,inner_h\n0,1\n20,2\n");
  EXPECT_THAT(bimodal({"validate-lips", "lips", "--clips", "t1", "--tracks", "short"}),
              ended(ExitCode::InvalidInput, HasSubstr("has 0 instants within the speech of 't1'")));
  files_.write("nose/t1.csv", "time_ms,nose\n0,1\n2000,2\n");
  EXPECT_THAT(bimodal({"validate-lips", "lips", "--clips", "t1", "--tracks", "nose"}),
              ended(ExitCode::InvalidInput, HasSubstr("no measure in common")));
}

}  // namespace
}  // namespace bimodal

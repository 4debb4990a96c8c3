// From text to articulation on the command line: tracks, figures, segments, continuum.

#include <filesystem>
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
  EXPECT_THAT(bimodal({"continuum", "b", "--steps", "3", "-o", path("none")}),
              ended(ExitCode::InvalidInput, HasSubstr("--vary")));
  EXPECT_THAT(bimodal({"continuum", "b", "w", "--in", "AA", "-o", path("none")}),
              ended(ExitCode::InvalidInput, HasSubstr("\"_\"")));
}

}  // namespace
}  // namespace bimodal

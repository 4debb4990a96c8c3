// Protocols as a user meets them when something in them is wrong: what is said, and how it ends.

#include <map>
#include <utility>

#include "runner/store/stored_session.hpp"
#include "tests/cli/command_line.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

using BadInput = CommandLine;

TEST_F(BadInput, ProtocolWithoutMistakesIsClean) {
  EXPECT_THAT(check(kProtocol), ended(ExitCode::Done, HasSubstr("no mistakes found")));
}

TEST_F(BadInput, FileThatIsNotJsonIsNamedWithItsLine) {
  const auto not_json =
      ended(ExitCode::InvalidInput, AllOf(HasSubstr("tried.json:2:"), HasSubstr("not JSON")));
  EXPECT_THAT(check("{\n  title: }\n"), not_json);
  EXPECT_THAT(bimodal({"rehearse", "tried.json", "--data", "x.sqlite"}), not_json);
  EXPECT_THAT(bimodal({"run", "tried.json", "--participant", "P01", "--data", "x.sqlite"}),
              not_json);
  EXPECT_THAT(bimodal({"stimuli", "mix", "tried.json", "--trial", "1", "-o", "x.wav"}), not_json);
  EXPECT_FALSE(std::filesystem::exists(path("x.sqlite")));
}

TEST_F(BadInput, WrongTypeIsNamedWithLinePointerAndRemedy) {
  EXPECT_THAT(
      check(replaced(kProtocol, "\"snr_db\": -4", "\"snr_db\": \"loud\"")),
      ended(ExitCode::InvalidInput,
            HasSubstr("tried.json:8: /conditions/0/snr_db: \"loud\" is not a number; give the "
                      "ratio in dB, e.g. -8")));
}

TEST_F(BadInput, UnknownKeyGetsTheNearestKnownOne) {
  EXPECT_THAT(check(replaced(kProtocol, "\"snr_db\"", "\"srn_db\"")),
              ended(ExitCode::InvalidInput,
                    HasSubstr("tried.json:8: /conditions/0/srn_db: the key \"srn_db\" is not "
                              "known; did you mean \"snr_db\"?")));
}

TEST_F(BadInput, AllMistakesAreToldAtOnce) {
  auto protocol = replaced(kProtocol, "\"snr_db\"", "\"srn_db\"");
  protocol = replaced(protocol, "\"fish\"", "\"qzxv\"");
  protocol = replaced(protocol, "\"seed\": 1", "\"seed\": \"one\"");
  EXPECT_THAT(check(protocol),
              ended(ExitCode::InvalidInput,
                    AllOf(HasSubstr("srn_db"), HasSubstr("qzxv"), HasSubstr("/seed"))));
}

TEST_F(BadInput, MissingFilesAreNamed) {
  const auto missing = ended(ExitCode::InvalidInput,
                             AllOf(HasSubstr("nowhere"), HasSubstr("there is no such file")));
  EXPECT_THAT(bimodal({"check", "nowhere.json"}), missing);
  EXPECT_THAT(bimodal({"check", "nowhere"}), missing);
  EXPECT_THAT(bimodal({"rehearse", "nowhere.json", "--data", "x.sqlite"}), missing);
  EXPECT_THAT(check(replaced(kProtocol, R"(["cat", "fish"])", R"("nowhere-words.json")")),
              ended(ExitCode::InvalidInput,
                    AllOf(HasSubstr("tried.json:6: /words:"),
                          HasSubstr("'nowhere-words.json'"),
                          HasSubstr("there is no such file"))));
}

TEST_F(BadInput, WordWithoutPronunciationIsNamed) {
  EXPECT_THAT(check(replaced(kProtocol, "\"fish\"", "\"qzxv\"")),
              ended(ExitCode::InvalidInput,
                    HasSubstr("tried.json:6: /words/1: \"qzxv\" has no pronunciation")));
}

TEST_F(BadInput, SoundThatClipsIsFoundBeforeTheSession) {
  auto loud = replaced(kProtocol, "\"snr_db\": -4", "\"snr_db\": -20");
  loud = replaced(loud, "\"speech_level_dbfs\": -30", "\"speech_level_dbfs\": 0");
  const auto clips = ended(ExitCode::InvalidInput,
                           AllOf(HasSubstr("condition \"voice\""),
                                 HasSubstr("would clip"),
                                 testing::ContainsRegex("[1-9][0-9]\\.[0-9] dB of headroom"),
                                 HasSubstr("lower /sound/speech_level_dbfs")));
  EXPECT_THAT(check(loud), clips);
  EXPECT_THAT(check(loud).output, HasSubstr("tried.json"));
  EXPECT_THAT(bimodal({"rehearse", "tried.json", "--data", "x.sqlite"}), clips);
  EXPECT_THAT(bimodal({"run",
                       "tried.json",
                       "--participant",
                       "P01",
                       "--display",
                       "headless",
                       "--audio",
                       "none",
                       "--answers",
                       "simulated",
                       "--data",
                       "y.sqlite"}),
              clips);
  EXPECT_TRUE(runner::read_sessions(path("y.sqlite")).empty());
}

TEST_F(BadInput, SoundThatOnlyOtherNoiseWouldClipIsWarnedOf) {
  const auto at_level = [](int level) {
    return replaced(
        kProtocol, "\"speech_level_dbfs\": -30", "\"speech_level_dbfs\": " + std::to_string(level));
  };
  int level = -40;
  while (level < -3 && check(at_level(level)).exit_code == 0) ++level;
  const auto first = check(at_level(level));
  EXPECT_THAT(first,
              ended(ExitCode::Findings,
                    AllOf(HasSubstr("tried.json:8: /conditions/0: warning: "),
                          HasSubstr("with the noise of another participant"),
                          HasSubstr("lower /sound/speech_level_dbfs"))));
}

TEST_F(BadInput, LevelThatCheckRecommendsDoesNotClip) {
  auto loud = replaced(kProtocol, "\"snr_db\": -4", "\"snr_db\": -20");
  loud = replaced(loud, "\"speech_level_dbfs\": -30", "\"speech_level_dbfs\": 0");
  const auto said = check(loud).output;
  constexpr std::string_view kBefore = "from 0 to ";
  const auto at = said.find(kBefore);
  ASSERT_NE(at, std::string::npos) << said;
  const auto level =
      said.substr(at + kBefore.size(), said.find(" or less", at) - at - kBefore.size());
  EXPECT_THAT(check(replaced(loud, "\"speech_level_dbfs\": 0", "\"speech_level_dbfs\": " + level)),
              ended(ExitCode::Done, HasSubstr("no mistakes found")));
}

TEST_F(BadInput, WordIsShownAsItIsWritten) {
  EXPECT_THAT(check(replaced(kProtocol, "\"fish\"", "\"stra\u00dfe\"")).output,
              HasSubstr("\"stra\u00dfe\" has no pronunciation"));
}

TEST_F(BadInput, FaceThatCannotBeIsToldWithItsPlaceAndWhatIsNear) {
  EXPECT_THAT(
      check(replaced(kProtocol, "\"seed\": 1", R"("seed": 1, "face": {"hide": ["tunge"]})")),
      ended(ExitCode::InvalidInput,
            AllOf(HasSubstr("/face/hide/0: the face has no part \"tunge\""),
                  HasSubstr("did you mean \"tongue\"?"))));
}

TEST_F(BadInput, MaterialsOfAFaceAreJudgedWithTheirOwnLines) {
  files_.write("mine.json", "{\n  \"surface\": {\"glos\": 1}\n}\n");
  const auto found = bimodal({"check", "seen-parts"});
  EXPECT_THAT(found, ended(ExitCode::Done, HasSubstr("no mistakes found")));
  const auto faced = replaced(
      std::string{kProtocol}, "\"seed\": 1", R"("seed": 1, "face": {"material": "mine.json"})");
  const auto seen =
      replaced(faced, "\"snr_db\": -4", R"("snr_db": -4, "visual": {"talker": "face"})");
  EXPECT_THAT(
      check(seen),
      ended(ExitCode::InvalidInput,
            AllOf(HasSubstr("mine.json:2: /surface/glos"), HasSubstr("did you mean \"gloss\"?"))));
}

TEST_F(BadInput, EmptyProtocolIsToldWhichFileToBeginWith) {
  const auto found = check(" \n");
  EXPECT_THAT(found, ended(ExitCode::InvalidInput, HasSubstr("begin with a copy of ")));
  constexpr std::string_view kBefore = "begin with a copy of ";
  const auto from = found.output.find(kBefore) + kBefore.size();
  EXPECT_TRUE(
      std::filesystem::exists(found.output.substr(from, found.output.find('\n', from) - from)));
}

TEST_F(BadInput, FaceOfEveryTrialStandsInTheDataFile) {
  EXPECT_THAT(bimodal({"rehearse", "seen-parts", "--participants", "3", "--data", "x.sqlite"}),
              ended(ExitCode::Done, HasSubstr("117 trials")));
  std::map<std::string, std::string> faces;
  for (const auto& session : runner::read_sessions(path("x.sqlite"))) {
    for (const auto& stored : session.trials) {
      const auto& [condition, face] = std::pair{stored.plan.condition, stored.plan.face};
      ASSERT_TRUE(face);
      EXPECT_EQ(faces.emplace(condition, *face).first->second, *face);
    }
  }
  EXPECT_EQ(faces.size(), 3U);
  EXPECT_THAT(faces.at("whole face"), HasSubstr(R"("tongue")"));
  EXPECT_THAT(faces.at("no tongue"), testing::Not(HasSubstr(R"("tongue")")));
  EXPECT_THAT(faces.at("lips only"), HasSubstr(R"("shown":["lips"])"));
}

}  // namespace
}  // namespace bimodal

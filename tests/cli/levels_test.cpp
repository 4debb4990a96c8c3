// Levels at the ear, as they are measured, kept and asked for.

#include "protocols/model/protocol.hpp"
#include "runner/cli/session_level.hpp"
#include "runner/store/stored_session.hpp"
#include "stimuli/base/error.hpp"
#include "tests/cli/command_line.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> operator+(std::vector<std::string> arguments, std::string last) {
  arguments.push_back(std::move(last));
  return arguments;
}

class Levels : public CommandLine {
 protected:
  Ended levels(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "levels");
    return bimodal(arguments, {"BIMODAL_LEVELS=levels.json"});
  }

  void ask_for_spl(double level) const {
    files_.write("two.json",
                 replaced(kProtocol,
                          "\"speech_level_dbfs\": -30",
                          "\"speech_level_dbspl\": " + std::to_string(level)));
  }
};

TEST_F(Levels, AreKeptListedAndReplaced) {
  EXPECT_THAT(levels({"list"}),
              ended(ExitCode::Findings, HasSubstr("no level has been measured yet")));
  EXPECT_THAT(levels({"set", "--device", "none", "--dbspl", "65.2", "--instrument", "meter"}),
              ended(ExitCode::Done, HasSubstr("kept in levels.json")));
  EXPECT_THAT(levels({"set",
                      "--device",
                      "none",
                      "--tone",
                      "1000",
                      "--dbfs",
                      "-20",
                      "--dbspl",
                      "75",
                      "--channel",
                      "2",
                      "--note",
                      "left knob at 3"}),
              ended(ExitCode::Done, Not(HasSubstr("in place of"))));
  EXPECT_THAT(levels({"set", "--device", "none", "--dbspl", "64"}),
              ended(ExitCode::Done, AllOf(HasSubstr("in place of"), HasSubstr("65.2 dB SPL"))));
  EXPECT_THAT(levels({"list"}),
              ended(ExitCode::Done,
                    AllOf(HasSubstr("noise 80-8000 Hz"),
                          HasSubstr("-30.0 dB FS =   64.0 dB SPL"),
                          Not(HasSubstr("65.2")),
                          HasSubstr("tone 1000 Hz"),
                          HasSubstr("channel 2"),
                          HasSubstr("left knob at 3"))));
}

TEST_F(Levels, WhatCouldNotBeReadAgainIsNotKept) {
  const std::vector<std::string> set{"set", "--device", "none", "--dbspl", "64", "--note"};
  EXPECT_THAT(levels(set + std::string(501, 'x')),
              ended(ExitCode::InvalidInput, HasSubstr("nothing was kept")));
  EXPECT_THAT(levels(set + "B\xe9K"),
              ended(ExitCode::InvalidInput, HasSubstr("nothing was kept: a text is not UTF-8")));
  EXPECT_THAT(levels({"list"}),
              ended(ExitCode::Findings, HasSubstr("no level has been measured yet")));
}

TEST_F(Levels, OptionsThatMakeNoSenseAreRefused) {
  EXPECT_THAT(levels({"set", "--device", "none", "--band", "8000-80", "--dbspl", "65"}),
              ended(ExitCode::InvalidInput, HasSubstr("'8000-80' is not a band")));
  EXPECT_THAT(levels({"set", "--device", "none", "--dbspl", "loud"}).exit_code, 2);
  EXPECT_THAT(levels({"set", "--device", "none"}).exit_code, 2);
  EXPECT_THAT(
      levels({"set", "--device", "none", "--tone", "1000", "--band", "80-90", "--dbspl", "5"})
          .exit_code,
      2);
  EXPECT_FALSE(std::filesystem::exists(path("levels.json")));
}

TEST_F(Levels, FileThatIsDamagedIsNamedAndKept) {
  files_.write("levels.json", "{ \"levels\": 3 }");
  EXPECT_THAT(levels({"set", "--device", "none", "--dbspl", "65"}),
              ended(ExitCode::InvalidInput,
                    AllOf(HasSubstr("levels.json:1"), HasSubstr("/levels: 3 is not"))));
  EXPECT_EQ(bytes("levels.json"), "{ \"levels\": 3 }");
}

TEST_F(Levels, CalibrationSoundIsPlayedForItsTime) {
  EXPECT_THAT(levels({"play", "--device", "none", "--seconds", "0.2", "--dbfs", "-25"}),
              ended(ExitCode::Done,
                    AllOf(HasSubstr("noise of 80-8000 Hz at -25 dB FS on both ears"),
                          HasSubstr("bimodal levels set"))));
  EXPECT_THAT(levels({"play", "--device", "none", "--dbfs", "0"}),
              ended(ExitCode::InvalidInput, HasSubstr("it would clip")));
}

TEST_F(Levels, ProtocolInDecibelsOfSoundPressureIsWarnedOfWithoutCalibration) {
  ask_for_spl(65);
  EXPECT_THAT(bimodal({"check", "two.json"}),
              ended(ExitCode::Findings, HasSubstr("/sound/speech_level_dbspl: warning: ")));
  EXPECT_THAT(bimodal(unattended({"--participant", "P01", "--trials", "1"})),
              ended(ExitCode::Done,
                    HasSubstr("nothing is heard: speech is mixed at -30 dB FS instead of the 65 "
                              "dB SPL")));
  EXPECT_THAT(bimodal({"rehearse", "two.json", "--trials", "1", "--data", "r.sqlite"}),
              ended(ExitCode::Done, HasSubstr("instead of the 65 dB SPL")));
  EXPECT_THAT(bimodal({"stimuli", "mix", "two.json", "--trial", "1", "-o", "x.wav"}),
              ended(ExitCode::InvalidInput, HasSubstr("give it by --dbfs")));
  EXPECT_THAT(
      bimodal({"stimuli", "mix", "two.json", "--trial", "1", "--dbfs", "-40", "-o", "x.wav"}),
      ended(ExitCode::Done, HasSubstr("speech -40.00 dB FS")));
}

runner::LevelTable table_of(double dbspl) {
  return runner::LevelTable{{{.device = "card",
                              .dbfs = Decibels{-30},
                              .dbspl = DecibelsSpl{dbspl},
                              .date = "2026-01-31"}}};
}

TEST(SessionLevel, SetsTheLevelThatGivesTheSoundPressure) {
  protocols::Sound sound{.speech_spl = DecibelsSpl{65}};
  const auto level = runner::settle_level(sound, "card", table_of(70));
  EXPECT_EQ(sound.speech_level, Decibels{-35});
  EXPECT_EQ(level.text,
            "speech at -35.0 dB FS is 65.0 dB SPL on 'card', as measured on 2026-01-31");
  EXPECT_THAT(level.record,
              AllOf(HasSubstr(R"("speech_dbfs":-35.0)"),
                    HasSubstr(R"("speech_dbspl":65.0)"),
                    HasSubstr(R"("wanted_dbspl":65.0)"),
                    HasSubstr(R"("dbspl":70.0)")));
}

TEST(SessionLevel, TellsTheSoundPressureOfALevelReFullScale) {
  protocols::Sound sound;
  const auto level = runner::settle_level(sound, "card", table_of(70));
  EXPECT_EQ(sound.speech_level, Decibels{-30});
  EXPECT_THAT(level.text, HasSubstr("is 70.0 dB SPL"));
  EXPECT_THAT(level.record, HasSubstr(R"("wanted_dbspl":null)"));
  EXPECT_EQ(runner::settle_level(sound, "another card", table_of(70)).text, "");
}

TEST(SessionLevel, RefusesSoundPressureWithoutCalibrationAndSaysHowToGetIt) {
  protocols::Sound sound{.speech_spl = DecibelsSpl{65}};
  try {
    static_cast<void>(runner::settle_level(sound, "another card", table_of(70)));
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("asks for speech of 65 dB SPL"),
                      HasSubstr("of 'another card' at 48000 samples per second has not been"),
                      HasSubstr("bimodal levels play --device 'another card' --band 80-8000")));
  }
}

TEST(SessionLevel, RefusesWhatLiesBeyondFullScale) {
  protocols::Sound sound{.speech_spl = DecibelsSpl{105}};
  try {
    static_cast<void>(runner::settle_level(sound, "card", table_of(70)));
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("would need 5.0 dB FS on 'card'"));
  }
}

}  // namespace
}  // namespace bimodal

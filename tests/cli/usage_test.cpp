// Missing devices, and command lines that cannot be meant.

#include "runner/store/stored_session.hpp"
#include "tests/cli/command_line.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class Usage : public CommandLine {
 protected:
  /// A session where no sound server runs and the only card does not exist. (One unusable device:
  /// PortAudio 19.6 aborts where ALSA's configuration knows none at all.)
  [[nodiscard]] Ended run_without_sound_system(const std::string& audio) const {
    files_.write("asound.conf", "pcm.nothing { type hw card 99 }\n");
    return bimodal(
        unattended_run("two.json", {"--participant", "P01", "--data", "x.sqlite"}, audio),
        {"JACK_DEFAULT_SERVER=nonexistent",
         "JACK_NO_START_SERVER=1",
         "ALSA_CONFIG_PATH=" + path("asound.conf")});
  }
};

TEST_F(Usage, WithoutAudioDeviceTheWayWithoutSoundIsTold) {
  const auto run = run_without_sound_system("default");
  // PortAudio also knows OSS, which a machine may have whatever ALSA's configuration says.
  if (run.exit_code == 0) GTEST_SKIP() << "PortAudio found a device all the same: " << run.output;
  EXPECT_THAT(run, ended(ExitCode::Device, HasSubstr("--audio none")));
  EXPECT_FALSE(std::filesystem::exists(path("x.sqlite")));
}

TEST_F(Usage, AudioDeviceThatIsNotThereIsNamed) {
  EXPECT_THAT(run_without_sound_system("no such device"),
              ended(ExitCode::Device, HasSubstr("--audio none")));
}

TEST_F(Usage, WithoutDisplayTheWayWithoutWindowIsTold) {
  const std::vector<std::string> arguments{
      "run", "two.json", "--participant", "P01", "--audio", "none", "--data", "x.sqlite"};
  const auto refused =
      ended(ExitCode::Device, AllOf(HasSubstr("display"), HasSubstr("--display headless")));
  EXPECT_THAT(bimodal(arguments, {"-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER=x11"}),
              refused);
  EXPECT_THAT(bimodal(arguments, {"SDL_VIDEODRIVER=dummy"}), refused);
  EXPECT_FALSE(std::filesystem::exists(path("x.sqlite")));
}

TEST_F(Usage, WrongUsageEndsWithTwo) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"ruin"},
                                                    {"run"},
                                                    {"run", "two.json"},
                                                    {"check"},
                                                    {"check", "two.json", "--loud"},
                                                    {"rehearse", "two.json", "--participants", "0"},
                                                    {"rehearse", "two.json", "--seed", "x"},
                                                    {"rehearse", "two.json", "--seed", "-1"},
                                                    {"rehearse", "two.json", "--trials", "0"},
                                                    {"stimuli"},
                                                    {"stimuli", "mix", "two.json"}}) {
    EXPECT_THAT(bimodal(arguments), ended(ExitCode::Usage, HasSubstr("--help")));
  }
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{}, {"report"}, {"report", "x.sqlite"}}) {
    EXPECT_THAT(run_command(files_.folder(), "bimodal-analysis", arguments),
                ended(ExitCode::Usage, HasSubstr("--help")));
  }
}

TEST_F(Usage, FolderThatIsNotThereIsToldAlikeByEveryVerbThatWritesAFile) {
  files_.write("protocol.json", kProtocol);
  files_.write("cat.lab", "0 0.1 k\n");
  const std::vector<std::vector<std::string>> commands{
      {"face", "-o", "nowhere/x.png"},
      {"render", "stew", "-o", "nowhere/x.png"},
      {"tracks", "stew", "-o", "nowhere/x.csv"},
      {"measures", "stew", "-o", "nowhere/x.csv"},
      {"sheets", "segments", "-o", "nowhere/x.png"},
      {"segments", "show", "UW", "-o", "nowhere/x.svg"},
      {"labels", "cat.lab", "-o", "nowhere/x.TextGrid"},
      {"align", "cat.wav", "--text", "cat", "-o", "nowhere/x.TextGrid"},
      {"stimuli", "mix", "protocol.json", "--trial", "1", "-o", "nowhere/x.wav"},
      {"stimuli", "strip", "protocol.json", "--word", "cat", "-o", "nowhere/x.png"},
      {"corpus", "sheet", "anna", "-o", "nowhere/x.png"}};
  for (const auto& command : commands) {
    EXPECT_THAT(bimodal(command), ended(ExitCode::Usage, HasSubstr("there is no folder")))
        << command.front();
  }
}

TEST_F(Usage, ParticipantWithoutNumberMustBeGivenOne) {
  EXPECT_THAT(bimodal(unattended({"--participant", "Anna", "--data", "x.sqlite"})),
              ended(ExitCode::InvalidInput, AllOf(HasSubstr("'Anna'"), HasSubstr("--number"))));
  EXPECT_FALSE(std::filesystem::exists(path("x.sqlite")));
  EXPECT_THAT(bimodal({"stimuli",
                       "mix",
                       "two.json",
                       "--trial",
                       "1",
                       "-o",
                       "x.wav",
                       "--participant",
                       "Anna",
                       "--number",
                       "3"}),
              ended(ExitCode::Done, HasSubstr("trial 1")));
}

TEST_F(Usage, TrialThatIsNotThereIsRefused) {
  for (const std::string trial : {"0", "3", "-1"}) {
    EXPECT_THAT(bimodal({"stimuli", "mix", "two.json", "--trial", trial, "-o", "x.wav"}),
                ended(ExitCode::InvalidInput, HasSubstr("trials 1 to 2")));
  }
  EXPECT_FALSE(std::filesystem::exists(path("x.wav")));
}

TEST_F(Usage, NameOfAParticipantMustStayOnOneLine) {
  EXPECT_THAT(bimodal(unattended({"--participant", "P\n2", "--data", "x.sqlite"})),
              ended(ExitCode::InvalidInput, HasSubstr("line breaks")));
}

TEST_F(Usage, UnknownVerbGetsTheNearestKnownOne) {
  EXPECT_THAT(bimodal({"chek", "two.json"}),
              ended(ExitCode::Usage, HasSubstr("there is no verb 'chek'; did you mean 'check'?")));
}

}  // namespace
}  // namespace bimodal

// The programs as a user meets them when something is wrong: what they say, and how they end.

#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "runner/store/session_store.hpp"
#include "runner/store/stored_session.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/exit_code.hpp"
#include "tests/cli/command.hpp"
#include "tests/protocols/written_files.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kProtocol = R"({
  "bimodal_protocol": 1,
  "title": "Two words",
  "seed": 1,
  "instructions": ["Listen."],
  "words": ["cat", "fish"],
  "conditions": [
    {"name": "voice", "auditory": {"talker": "festival:kal"}, "snr_db": -4}
  ],
  "sound": {"speech_level_dbfs": -30}
}
)";

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

/// Ended with `code`, having written what matches `output`.
testing::Matcher<Ended> ended(ExitCode code, const testing::Matcher<std::string>& output) {
  return AllOf(testing::Field("output", &Ended::output, output),
               testing::Field("exit_code", &Ended::exit_code, static_cast<int>(code)));
}

class BadInput : public testing::Test {
 protected:
  BadInput() { files_.write("two.json", kProtocol); }

  [[nodiscard]] Ended bimodal(const std::vector<std::string>& arguments,
                              const std::vector<std::string>& environment = {}) const {
    return run_command(files_.folder(), "bimodal", arguments, environment);
  }

  [[nodiscard]] Ended check(std::string_view protocol) const {
    files_.write("tried.json", protocol);
    return bimodal({"check", "tried.json"});
  }

  /// A session without window, sound and person; `more` comes last.
  [[nodiscard]] static std::vector<std::string> unattended(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{
        "run", "two.json", "--display", "headless", "--audio", "none", "--answers", "simulated"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  [[nodiscard]] std::string path(std::string_view name) const {
    return (files_.folder() / name).string();
  }

  [[nodiscard]] std::string bytes(std::string_view name) const {
    std::ifstream in{files_.folder() / name, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
  }

  WrittenFiles files_;
};

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

TEST_F(BadInput, DataFileThatIsNotThereIsNamedByTheAnalysis) {
  const auto run = run_command(
      files_.folder(), "bimodal-analysis", {"report", "nowhere.sqlite", "-o", path("report")});
  EXPECT_THAT(run.output, HasSubstr("nowhere.sqlite"));
  EXPECT_THAT(run.exit_code, testing::AnyOf(3, 5));
  EXPECT_FALSE(std::filesystem::exists(path("report/report.html")));
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

// Found by a newcomer: the noise of some later participant clipped at a level that check allowed.
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

TEST_F(BadInput, DataFileOfANewerSchemaIsRefusedByAllAndLeftAsItIs) {
  runner::open_sqlite_store(path("newer.sqlite")).reset();
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path("newer.sqlite").c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database, "PRAGMA user_version = 99", nullptr, nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(database);
  const auto before = bytes("newer.sqlite");

  const auto refused = ended(ExitCode::Store,
                             AllOf(HasSubstr("'newer.sqlite'"),
                                   HasSubstr("schema version 99"),
                                   HasSubstr("update bimodal")));
  EXPECT_THAT(bimodal({"rehearse", "two.json", "--data", "newer.sqlite"}), refused);
  EXPECT_THAT(bimodal(unattended({"--participant", "P01", "--data", "newer.sqlite"})), refused);
  EXPECT_THAT(bimodal({"run", "two.json", "--participant", "P01", "--data", "newer.sqlite"}),
              refused);  // with a person: before any window
  for (const std::string verb : {"report", "matrix"}) {
    std::vector<std::string> arguments{verb, "newer.sqlite"};
    if (verb == "report") {
      arguments.insert(arguments.end(), {"-o", "report"});
    } else {
      arguments.insert(arguments.end(), {"--unit", "vowel", "--condition", "voice"});
    }
    EXPECT_THAT(run_command(files_.folder(), "bimodal-analysis", arguments), refused);
  }
  EXPECT_EQ(bytes("newer.sqlite"), before);
}

TEST_F(BadInput, FileThatIsNoDataFileIsRefusedAndLeftAsItIs) {
  files_.write("notes.txt", "my notes, not to be lost\n");
  EXPECT_THAT(bimodal({"rehearse", "two.json", "--data", "notes.txt"}),
              ended(ExitCode::Store, HasSubstr("notes.txt")));
  EXPECT_EQ(bytes("notes.txt"), "my notes, not to be lost\n");

  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path("other.sqlite").c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database, "CREATE TABLE mine (a)", nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(database);
  const auto before = bytes("other.sqlite");
  EXPECT_THAT(bimodal({"rehearse", "two.json", "--data", "other.sqlite"}),
              ended(ExitCode::Store, HasSubstr("'other.sqlite' is not a bimodal data file")));
  EXPECT_EQ(bytes("other.sqlite"), before);
}

TEST_F(BadInput, WithoutAudioDeviceTheWayWithoutSoundIsTold) {
  // One unusable device: PortAudio 19.6 aborts where ALSA's configuration knows none at all.
  files_.write("asound.conf", "pcm.nothing { type hw card 99 }\n");
  const auto run = bimodal({"run",
                            "two.json",
                            "--participant",
                            "P01",
                            "--display",
                            "headless",
                            "--answers",
                            "simulated",
                            "--audio",
                            "default",
                            "--data",
                            "x.sqlite"},
                           {"JACK_DEFAULT_SERVER=nonexistent",
                            "JACK_NO_START_SERVER=1",
                            "ALSA_CONFIG_PATH=" + path("asound.conf")});
  if (run.exit_code == 0) GTEST_SKIP() << "PortAudio found a device all the same: " << run.output;
  EXPECT_THAT(run, ended(ExitCode::Device, HasSubstr("--audio none")));
  EXPECT_FALSE(std::filesystem::exists(path("x.sqlite")));
}

TEST_F(BadInput, AudioDeviceThatIsNotThereIsNamed) {
  files_.write("asound.conf", "pcm.nothing { type hw card 99 }\n");
  EXPECT_THAT(bimodal({"run",
                       "two.json",
                       "--participant",
                       "P01",
                       "--display",
                       "headless",
                       "--answers",
                       "simulated",
                       "--audio",
                       "no such device",
                       "--data",
                       "x.sqlite"},
                      {"JACK_DEFAULT_SERVER=nonexistent",
                       "JACK_NO_START_SERVER=1",
                       "ALSA_CONFIG_PATH=" + path("asound.conf")}),
              ended(ExitCode::Device, HasSubstr("--audio none")));
}

TEST_F(BadInput, WithoutDisplayTheWayWithoutWindowIsTold) {
  const std::vector<std::string> arguments{
      "run", "two.json", "--participant", "P01", "--audio", "none", "--data", "x.sqlite"};
  const auto refused =
      ended(ExitCode::Device, AllOf(HasSubstr("display"), HasSubstr("--display headless")));
  EXPECT_THAT(bimodal(arguments, {"-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER=x11"}),
              refused);
  EXPECT_THAT(bimodal(arguments, {"SDL_VIDEODRIVER=dummy"}), refused);
  EXPECT_FALSE(std::filesystem::exists(path("x.sqlite")));
}

TEST_F(BadInput, FolderThatCannotBeWrittenToIsNamed) {
  const auto refused = [](std::string_view file) {
    return ended(ExitCode::Store,
                 AllOf(HasSubstr("'" + std::string{file} + "'"),
                       HasSubstr("choose a folder that you may write to with --data")));
  };
  for (const std::string file :
       {"two.json/x.sqlite", "/proc/x.sqlite", "no/such/folder/x.sqlite"}) {
    EXPECT_THAT(bimodal({"rehearse", "two.json", "--data", file}), refused(file));
    EXPECT_THAT(bimodal(unattended({"--participant", "P01", "--data", file})), refused(file));
  }
  if (geteuid() != 0) {  // root may write everywhere
    std::filesystem::create_directory(path("sealed"));
    std::filesystem::permissions(path("sealed"), std::filesystem::perms{0555});
    EXPECT_THAT(bimodal({"rehearse", "two.json", "--data", "sealed/x.sqlite"}),
                refused("sealed/x.sqlite"));
  }
}

TEST_F(BadInput, ReportThatCannotBeWrittenIsNamed) {
  ASSERT_EQ(bimodal({"rehearse", "two.json", "--data", "x.sqlite"}).exit_code, 0);
  EXPECT_THAT(
      run_command(
          files_.folder(), "bimodal-analysis", {"report", "x.sqlite", "-o", "two.json/report"}),
      ended(ExitCode::InvalidInput, AllOf(HasSubstr("two.json/report"), HasSubstr("-o"))));
}

TEST_F(BadInput, WrongUsageEndsWithTwo) {
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

TEST_F(BadInput, ParticipantWithoutNumberMustBeGivenOne) {
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

TEST_F(BadInput, TrialThatIsNotThereIsRefused) {
  for (const std::string trial : {"0", "3", "-1"}) {
    EXPECT_THAT(bimodal({"stimuli", "mix", "two.json", "--trial", trial, "-o", "x.wav"}),
                ended(ExitCode::InvalidInput, HasSubstr("trials 1 to 2")));
  }
  EXPECT_FALSE(std::filesystem::exists(path("x.wav")));
}

TEST_F(BadInput, SimulatedParticipantsAreNotRepeatedByMistakeEither) {
  const std::vector<std::string> rehearse{"rehearse", "two.json", "--data", "x.sqlite"};
  ASSERT_EQ(bimodal(rehearse).exit_code, 0);
  EXPECT_THAT(bimodal(rehearse),
              ended(ExitCode::InvalidInput,
                    AllOf(HasSubstr("participant 'S01' (2 trials, complete, simulated)"),
                          HasSubstr("--again"))));
  EXPECT_EQ(runner::read_sessions(path("x.sqlite")).size(), 1U);
  auto again = rehearse;
  again.emplace_back("--again");
  EXPECT_EQ(bimodal(again).exit_code, 0);
}

TEST_F(BadInput, NameOfAParticipantMustStayOnOneLine) {
  EXPECT_THAT(bimodal(unattended({"--participant", "P\n2", "--data", "x.sqlite"})),
              ended(ExitCode::InvalidInput, HasSubstr("line breaks")));
}

TEST_F(BadInput, UnknownVerbGetsTheNearestKnownOne) {
  EXPECT_THAT(bimodal({"chek", "two.json"}),
              ended(ExitCode::Usage, HasSubstr("there is no verb 'chek'; did you mean 'check'?")));
}

TEST_F(BadInput, WordIsShownAsItIsWritten) {
  EXPECT_THAT(check(replaced(kProtocol, "\"fish\"", "\"stra\u00dfe\"")).output,
              HasSubstr("\"stra\u00dfe\" has no pronunciation"));
}

TEST_F(BadInput, EmptyDataFileBecomesPrivate) {
  files_.write("empty.sqlite", "");
  std::filesystem::permissions(path("empty.sqlite"), std::filesystem::perms{0644});
  ASSERT_EQ(bimodal({"rehearse", "two.json", "--data", "empty.sqlite"}).exit_code, 0);
  EXPECT_EQ(std::filesystem::status(path("empty.sqlite")).permissions(),
            std::filesystem::perms{0600});
}

TEST_F(BadInput, SessionThatAParticipantHasAlreadyIsNotRepeatedByMistake) {
  {
    const auto store = runner::open_sqlite_store(path("x.sqlite"));
    const auto session = store->begin({.participant = "P01",
                                       .participant_number = 1,
                                       .session_number = 1,
                                       .protocol_title = "Two words",
                                       .protocol_text = kProtocol,
                                       .protocol_sha256 = sha256(std::string_view{kProtocol}),
                                       .seed = 1,
                                       .program_version = "0",
                                       .started_utc = "2026-01-01T00:00:00Z"},
                                      {});
    store->end(session, "stopped", "2026-01-01T00:10:00Z");
  }
  // No display, so that a run that is not refused ends there.
  const std::vector<std::string> nowhere{"SDL_VIDEODRIVER=dummy"};
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"run", "two.json", "--audio", "none", "--data", "x.sqlite"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return bimodal(arguments, nowhere);
  };
  EXPECT_THAT(run({"--participant", "P01"}),
              ended(ExitCode::InvalidInput,
                    AllOf(HasSubstr("already has session 1 of participant 'P01'"),
                          HasSubstr("stopped"),
                          HasSubstr("--again"))));
  for (const std::vector<std::string>& allowed :
       {std::vector<std::string>{"--participant", "P01", "--again"}, {"--participant", "P02"}}) {
    EXPECT_THAT(run(allowed), ended(ExitCode::Device, Not(HasSubstr("already has"))));
  }
}

}  // namespace
}  // namespace bimodal

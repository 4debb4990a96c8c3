// Triggers as an experimenter meets them: before a session, in it, and in its data.

#include <array>
#include <string>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "runner/store/stored_session.hpp"
#include "tests/cli/command_line.hpp"
#include "tests/support/pseudo_terminal.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class TriggersCli : public CommandLine {
 protected:
  /// Writes the small protocol, made short, with these triggers as "two.json".
  void ask_for(const std::string& triggers) {
    constexpr std::string_view kShort =
        R"("sound": {"noise": {"lead_s": 0.1, "trail_s": 0.1}},
           "intervals": {"fixation_s": 0.1, "lead_s": 0.1, "trail_s": 0.1, "pause_s": 0.1})";
    const auto quick = replaced(kProtocol, R"("sound": {"speech_level_dbfs": -30})", kShort);
    files_.write("two.json",
                 replaced(quick, "\"seed\": 1,", "\"seed\": 1, \"triggers\": " + triggers + ","));
  }

  static std::string serial(const std::string& port) {
    return R"({"serial": {"port": ")" + port +
           R"(", "codes": {"trial_start": 9, "auditory_zero": 2, "response": 4}}})";
  }

  std::vector<runner::StoredTrial> stored() const {
    return runner::read_sessions(path("two.sqlite"), runner::Detail::Everything).at(0).trials;
  }
};

std::vector<std::string> events_of(const std::vector<runner::TriggerRecord>& triggers,
                                   std::string_view kind) {
  std::vector<std::string> events;
  for (const auto& trigger : triggers) {
    if (trigger.kind == kind) events.push_back(trigger.event);
  }
  return events;
}

TEST_F(TriggersCli, BytesOfASessionArriveAndAreStoredWithTheirInstants) {
  const PseudoTerminal terminal;
  ask_for(serial(terminal.port()));
  EXPECT_THAT(bimodal(unattended({"--participant", "P01"})),
              ended(ExitCode::Done, HasSubstr("none flagged")));
  EXPECT_EQ(terminal.arrived(6), "\x09\x02\x04\x09\x02\x04");
  const auto trials = stored();
  ASSERT_EQ(trials.size(), 2U);
  for (const auto& [plan, trial] : trials) {
    EXPECT_THAT(events_of(trial.triggers, "serial"),
                ElementsAre("trial_start", "auditory_zero", "response"));
    for (const auto& trigger : trial.triggers) {
      ASSERT_TRUE(trigger.sent.has_value());
      EXPECT_GE(*trigger.sent, trigger.planned);
      EXPECT_GT(trigger.uncertainty, Duration::zero());
      EXPECT_EQ(trigger.source, "write_returned");
    }
    EXPECT_EQ(trial.triggers.at(1).planned, trial.onsets.at(0).planned);
    EXPECT_EQ(trial.triggers.at(2).planned, trial.response.submitted);
  }
}

/// Lines that arrive from a local socket until it is closed.
std::string lines_from(const std::string& path) {
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof(address.sun_path) - 1);
  std::string lines;
  if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0) {
    std::array<char, 4096> part{};
    for (auto size = ::read(socket, part.data(), part.size()); size > 0;
         size = ::read(socket, part.data(), part.size())) {
      lines.append(part.data(), static_cast<std::size_t>(size));
    }
  }
  ::close(socket);
  return lines;
}

TEST_F(TriggersCli, ProgramsThatListenHearOfEveryEvent) {
  ask_for(R"({"socket": {"path": "t.socket"}})");
  StartedCommand session{
      files_.folder(), "bimodal", unattended({"--participant", "P01", "--trials", "1"}), {}};
  ASSERT_TRUE(session.await("no display"));  // the devices are open
  const auto lines = lines_from(path("t.socket"));
  EXPECT_THAT(session.end(), ended(ExitCode::Done, HasSubstr("complete")));
  for (const auto* event : {"trial_start", "auditory_zero", "stimulus_end", "response"}) {
    EXPECT_THAT(lines,
                HasSubstr(std::string{"{\"event\":\""} + event +
                          "\",\"trial\":0,\"condition\":\"voice\",\"planned_ns\":"));
  }
  EXPECT_FALSE(std::filesystem::exists(path("t.socket")));
  const auto triggers = stored().at(0).trial.triggers;
  EXPECT_THAT(events_of(triggers, "socket"),
              ElementsAre("trial_start", "auditory_zero", "stimulus_end", "response"));
  for (const auto& trigger : triggers) EXPECT_TRUE(trigger.sent.has_value());
}

TEST_F(TriggersCli, PortThatVanishesFlagsTrialsAndTheSessionGoesOn) {
  PseudoTerminal terminal;
  ask_for(serial(terminal.port()));
  StartedCommand session{files_.folder(), "bimodal", unattended({"--participant", "P01"}), {}};
  EXPECT_EQ(terminal.arrived(1), "\x09");
  terminal.unplug();
  EXPECT_THAT(session.end(), ended(ExitCode::Done, HasSubstr("complete: 2 of 2 trials")));
  const auto trials = stored();
  ASSERT_EQ(trials.size(), 2U);
  for (const auto& [plan, trial] : trials) {
    EXPECT_TRUE(trial.flagged);
    ASSERT_EQ(trial.events.size(), 1U);
    EXPECT_EQ(trial.events[0].kind, "trigger_lost");
    EXPECT_THAT(trial.events[0].detail,
                AllOf(HasSubstr(terminal.port()), HasSubstr("auditory_zero, response")));
    EXPECT_EQ(trial.triggers.back().sent, std::nullopt);
  }
}

TEST_F(TriggersCli, PortThatIsNotThereIsWarnedOfAndRefusedBeforeTheSession) {
  ask_for(serial("/dev/ttyNoSuchThing"));
  EXPECT_THAT(bimodal({"check", "two.json"}),
              ended(ExitCode::Findings,
                    AllOf(HasSubstr("two.json:4: /triggers/serial/port: warning: there is no port "
                                    "'/dev/ttyNoSuchThing' here now"),
                          HasSubstr("bimodal devices"))));
  EXPECT_THAT(bimodal(unattended({"--participant", "P01"})),
              ended(ExitCode::Device,
                    AllOf(HasSubstr("'/dev/ttyNoSuchThing'"), HasSubstr("--no-triggers"))));
  EXPECT_FALSE(std::filesystem::exists(path("two.sqlite")));
}

TEST_F(TriggersCli, PortThatIsNoneAndPlaceWhereNoSocketCanBeAreWarnedOf) {
  ask_for(serial(path("two.json")));
  EXPECT_THAT(bimodal({"check", "two.json"}),
              ended(ExitCode::Findings, HasSubstr("two.json' is no port")));
  ask_for(R"({"socket": {"path": "nowhere/t.socket"}})");
  EXPECT_THAT(bimodal({"check", "two.json"}),
              ended(ExitCode::Findings, HasSubstr("there is no folder 'nowhere'")));
  ask_for(R"({"socket": {"path": "two.json"}})");
  EXPECT_THAT(bimodal({"check", "two.json"}),
              ended(ExitCode::Findings, HasSubstr("'two.json' is there already")));
}

TEST_F(TriggersCli, SessionWithoutTheEquipmentSaysSoInItsData) {
  ask_for(R"({"photodiode": {}, "click": {"channel": 3}, "serial": {"port": "/dev/ttyNoSuchThing",
             "codes": {"response": 4}}})");
  EXPECT_THAT(bimodal(unattended({"--participant", "P01", "--no-triggers", "--trials", "1"})),
              ended(ExitCode::Done, HasSubstr("complete")));
  const auto session = runner::read_sessions(path("two.sqlite"), runner::Detail::Everything).at(0);
  EXPECT_THAT(session.session.display.description, Not(HasSubstr("photodiode")));
  for (const auto& stored : session.trials) EXPECT_THAT(stored.trial.triggers, IsEmpty());
  const auto data = bytes("two.sqlite") + bytes("two.sqlite-wal");
  EXPECT_THAT(data, HasSubstr("photodiode, click, serial left out by --no-triggers"));
}

TEST_F(TriggersCli, PatchAndClickAreStoredAsPlannedAndReported) {
  ask_for(R"({"photodiode": {}, "click": {"channel": 3}})");
  EXPECT_THAT(bimodal(unattended({"--participant", "P01", "--trials", "1"})),
              ended(ExitCode::Done, HasSubstr("")));
  const auto session = runner::read_sessions(path("two.sqlite"), runner::Detail::Everything).at(0);
  EXPECT_THAT(session.session.display.description, HasSubstr("60 pixels in the upper left corner"));
  for (const auto& stored : session.trials) {
    const auto& triggers = stored.trial.triggers;
    EXPECT_THAT(events_of(triggers, "photodiode"), ElementsAre("auditory_zero"));
    EXPECT_EQ(triggers.at(0).source, "predicted");
    EXPECT_THAT(events_of(triggers, "click"), ElementsAre("auditory_zero"));
    EXPECT_EQ(triggers.at(1).sent, std::nullopt);  // --audio none
    EXPECT_EQ(triggers.at(1).source, "none");
  }
}

TEST_F(TriggersCli, PatchThatHidesThePictureIsWarnedOf) {
  auto seen = replaced(kProtocol,
                       R"("auditory": {"talker": "festival:kal"}, "snr_db": -4)",
                       R"("visual": {"talker": "face"})");
  seen = replaced(seen, "\"seed\": 1,", R"("seed": 1, "triggers": {"photodiode": {SIZE}},)");
  EXPECT_THAT(check(replaced(seen, "SIZE", R"("size_px": 320)")),
              ended(ExitCode::Done, HasSubstr("no mistakes found")));
  EXPECT_THAT(check(replaced(seen, "SIZE", R"("size_px": 321)")),
              ended(ExitCode::Findings, HasSubstr("hides a part of the picture")));
}

}  // namespace
}  // namespace bimodal

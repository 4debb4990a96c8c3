// Sessions watched from another process.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "runner/store/stored_session.hpp"
#include "stimuli/base/exit_code.hpp"
#include "tests/cli/command.hpp"
#include "tests/cli/six_words.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

class Monitor : public testing::Test {
 protected:
  Monitor() { files_.write("six.json", kSixWords); }

  [[nodiscard]] StartedCommand session(const std::string& trials) const {
    return {files_.folder(),
            "bimodal",
            unattended_run("six.json",
                           {"--data", "x.sqlite", "--participant", "P01", "--trials", trials})};
  }

  [[nodiscard]] Ended monitor(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"monitor", "x.sqlite"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_command(files_.folder(), "bimodal", arguments);
  }

  [[nodiscard]] std::filesystem::path socket() const { return files_ / "x.sqlite.monitor"; }

  [[nodiscard]] std::vector<runner::StoredSession> stored() const {
    return runner::read_sessions(files_ / "x.sqlite", runner::Detail::Everything);
  }

  WrittenFiles files_;
};

TEST_F(Monitor, ShowsARunningSessionAndAfterItsEndWhatTheFileHolds) {
  auto running = session("3");
  ASSERT_TRUE(running.await("trial 2 of 3"));
  EXPECT_EQ(std::filesystem::status(socket()).permissions(), std::filesystem::perms{0600});
  const auto shown = monitor({"--once"});
  EXPECT_EQ(shown.exit_code, 0);
  EXPECT_THAT(shown.output,
              AllOf(HasSubstr("Six words in haste"),
                    HasSubstr("P01   session 1   simulated answers"),
                    HasSubstr(" of 3   block 1 of 1   main   voice"),
                    HasSubstr("refresh 16.667 ms (not measured)")));
  const auto lines = monitor({"--once", "--json"});
  EXPECT_EQ(lines.exit_code, 0);
  std::vector<std::string> kinds;
  std::istringstream read{lines.output};
  for (std::string line; std::getline(read, line);) {
    kinds.push_back(nlohmann::json::parse(line).at("kind"));
  }
  EXPECT_THAT(kinds,
              AllOf(Contains("session"), Contains("trial"), Contains("tally"), Contains("health")));

  const auto ended = running.end();
  EXPECT_THAT(ended.output, HasSubstr("complete: 3 of 3 trials stored"));
  EXPECT_FALSE(std::filesystem::exists(socket()));
  const auto file = monitor({"--once"});
  EXPECT_EQ(file.exit_code, 1);
  EXPECT_THAT(file.output,
              AllOf(HasSubstr("no session that stores in 'x.sqlite' is running"),
                    HasSubstr("complete: 3 of 3 trials"),
                    HasSubstr("voice")));
}

TEST_F(Monitor, PausesResumesAndStopsASession) {
  auto running = session("6");
  ASSERT_TRUE(running.await("trial 2 of 6"));
  const auto paused = monitor({"--pause"});
  EXPECT_EQ(paused.exit_code, 0) << paused.output;
  EXPECT_THAT(paused.output, HasSubstr("paused\n"));
  ASSERT_THAT(stored(), SizeIs(1));
  const auto trials = stored()[0].trials.size();
  EXPECT_THAT(monitor({"--once"}).output,
              AllOf(HasSubstr("PAUSED"), HasSubstr("asked for by the experimenter")));
  EXPECT_EQ(monitor({"--pause"}).exit_code, 0);  // it is already
  EXPECT_EQ(stored()[0].trials.size(), trials);
  const auto resumed = monitor({"--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.output;
  ASSERT_TRUE(running.await("resumed"));
  const auto stopped = monitor({"--stop"});
  EXPECT_EQ(stopped.exit_code, 0) << stopped.output;
  EXPECT_THAT(stopped.output, HasSubstr("stopped: "));
  const auto ended = running.end();
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.output, HasSubstr("of 6 trials stored in x.sqlite"));
  EXPECT_EQ(stored()[0].outcome, "stopped");
  EXPECT_GE(stored()[0].trials.size(), trials);
}

TEST_F(Monitor, TellsWhatHappensLineByLineWhereThereIsNoTerminalAndHowItEnds) {
  auto running = session("3");
  ASSERT_TRUE(running.await("trial 1 of 3"));
  StartedCommand watching{files_.folder(), "bimodal", {"monitor", "x.sqlite"}};
  StartedCommand killed{files_.folder(), "bimodal", {"monitor", "x.sqlite", "--json"}};
  ASSERT_TRUE(killed.await("\"kind\":\"trial\""));
  killed.kill_at_once();  // never touches the session
  EXPECT_THAT(running.end().output, HasSubstr("complete: 3 of 3 trials stored"));
  const auto watched = watching.end();
  EXPECT_EQ(watched.exit_code, 0);
  EXPECT_THAT(watched.output,
              AllOf(HasSubstr("Six words in haste"),
                    HasSubstr("trial 3 of 3"),
                    HasSubstr("answer: "),
                    HasSubstr("complete: 3 of 3 trials stored in x.sqlite, 0 flagged")));
}

TEST_F(Monitor, SaysSoWhenTheSessionIsTornAway) {
  auto running = session("6");
  ASSERT_TRUE(running.await("trial 2 of 6"));
  StartedCommand watching{files_.folder(), "bimodal", {"monitor", "x.sqlite"}};
  ASSERT_TRUE(watching.await("Six words in haste"));
  running.kill_at_once();
  const auto watched = watching.end();
  EXPECT_EQ(watched.exit_code, 1);
  EXPECT_THAT(watched.output, HasSubstr("gone without a word"));
  static_cast<void>(running.end());
  EXPECT_TRUE(std::filesystem::exists(socket()));  // left behind
  EXPECT_THAT(monitor({"--once"}).output, HasSubstr("interrupted: "));

  auto next = StartedCommand{
      files_.folder(),
      "bimodal",
      unattended_run("six.json", {"--data", "x.sqlite", "--participant", "P02", "--trials", "1"})};
  EXPECT_THAT(next.end().output, AllOf(HasSubstr("complete"), Not(HasSubstr("cannot be watched"))));
}

TEST_F(Monitor, OfASecondSessionInTheSameFileIsRefusedAndTheSessionRunsAllTheSame) {
  auto first = session("6");
  ASSERT_TRUE(first.await("trial 1 of 6"));
  const auto second = run_command(
      files_.folder(),
      "bimodal",
      unattended_run("six.json", {"--data", "x.sqlite", "--participant", "P02", "--trials", "1"}));
  EXPECT_EQ(second.exit_code, 0);
  EXPECT_THAT(second.output, AllOf(HasSubstr("cannot be watched"), HasSubstr("complete: 1 of 1")));
  EXPECT_THAT(monitor({"--once"}).output, HasSubstr("P01"));
  static_cast<void>(monitor({"--stop"}));
  EXPECT_THAT(first.end().output, HasSubstr("stopped"));
}

TEST_F(Monitor, OfAFileThatIsNotThereNamesIt) {
  const auto run = monitor({});
  EXPECT_EQ(run.exit_code, static_cast<int>(ExitCode::Store));
  EXPECT_THAT(run.output, HasSubstr("'x.sqlite'"));
}

TEST_F(Monitor, TakesOneRequestAtATime) {
  EXPECT_EQ(monitor({"--pause", "--stop"}).exit_code, static_cast<int>(ExitCode::Usage));
}

TEST_F(Monitor, FindsASessionWhosePathIsTooLongForASocket) {
  const auto deep = files_.folder() / std::string(90, 'd') / std::string(90, 'e');
  std::filesystem::create_directories(deep);
  const auto data = (deep / "x.sqlite").string();
  StartedCommand running{files_.folder(),
                         "bimodal",
                         unattended_run("six.json", {"--data", data, "--participant", "P01"})};
  ASSERT_TRUE(running.await("trial 1 of 6"));
  const auto stopped = run_command(files_.folder(), "bimodal", {"monitor", data, "--stop"});
  EXPECT_EQ(stopped.exit_code, 0) << stopped.output;
  EXPECT_THAT(running.end().output, HasSubstr("stopped"));
}

}  // namespace
}  // namespace bimodal

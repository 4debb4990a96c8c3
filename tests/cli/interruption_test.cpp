// What a session that is torn away leaves behind: every trial that was answered, and a file that
// can be read and gone on with.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/store/sqlite.hpp"
#include "runner/store/stored_session.hpp"
#include "tests/cli/command.hpp"
#include "tests/cli/six_words.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<std::string> run_of(const std::string& participant, const std::string& trials) {
  return unattended_run("six.json",
                        {"--data", "x.sqlite", "--participant", participant, "--trials", trials});
}

TEST(Interruption, OfAProcessLosesNoAnsweredTrial) {
  WrittenFiles files;
  files.write("six.json", kSixWords);
  const auto data = files.folder() / "x.sqlite";
  {
    StartedCommand session{files.folder(), "bimodal", run_of("P01", "6")};
    ASSERT_TRUE(session.await("trial 3 of 6"));  // announced when the second has been stored
    session.kill_at_once();
    EXPECT_EQ(session.end().exit_code, -1);
  }
  const auto sessions = runner::read_sessions(data, runner::Detail::Everything);
  ASSERT_THAT(sessions, SizeIs(1));
  ASSERT_THAT(sessions[0].trials, SizeIs(2));
  EXPECT_THAT(sessions[0].outcome, IsEmpty());
  for (const auto& [plan, trial] : sessions[0].trials) {
    EXPECT_THAT(trial.response.text, testing::Not(IsEmpty()));
    EXPECT_TRUE(trial.sound.has_value());
    EXPECT_THAT(trial.keystrokes, testing::Not(IsEmpty()));
  }
  EXPECT_EQ(std::filesystem::status(data).permissions(), std::filesystem::perms{0600});

  const auto next = run_command(files.folder(), "bimodal", run_of("P02", "1"));
  EXPECT_EQ(next.exit_code, 0) << next.output;
  const auto report =
      run_command(files.folder(), "bimodal-analysis", {"report", "x.sqlite", "-o", "report"});
  EXPECT_EQ(report.exit_code, 0) << report.output;
  EXPECT_THAT(runner::read_sessions(data), SizeIs(2));
}

TEST(Interruption, ByCtrlCEndsTheSessionInOrder) {
  WrittenFiles files;
  files.write("six.json", kSixWords);
  StartedCommand session{files.folder(), "bimodal", run_of("P01", "6")};
  ASSERT_TRUE(session.await("trial 2 of 6"));
  session.interrupt();
  const auto ended = session.end();
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.output, HasSubstr("stopped: 1 of 6 trials stored in x.sqlite"));
  const auto sessions = runner::read_sessions(files.folder() / "x.sqlite");
  ASSERT_THAT(sessions, SizeIs(1));
  EXPECT_EQ(sessions[0].outcome, "stopped");
}

TEST(Interruption, IsMadeUpForByResumingWhichCountsTheWholeSession) {
  WrittenFiles files;
  files.write("six.json", kSixWords);
  {
    StartedCommand session{files.folder(), "bimodal", run_of("P01", "6")};
    ASSERT_TRUE(session.await("trial 3 of 6"));
    session.kill_at_once();
    static_cast<void>(session.end());
  }
  auto arguments = run_of("P01", "6");
  arguments.emplace_back("--resume");
  const auto resumed = run_command(files.folder(), "bimodal", arguments);
  EXPECT_EQ(resumed.exit_code, 0);
  EXPECT_THAT(resumed.output,
              HasSubstr("complete: 6 of 6 trials stored in x.sqlite, 2 of them before"));
}

TEST(Interruption, IsNoneWhileTheSessionRuns) {
  WrittenFiles files;
  files.write("six.json", kSixWords);
  StartedCommand session{files.folder(), "bimodal", run_of("P01", "6")};
  ASSERT_TRUE(session.await("trial 2 of 6"));
  auto arguments = run_of("P01", "6");
  arguments.emplace_back("--resume");
  const auto resumed = run_command(files.folder(), "bimodal", arguments);
  EXPECT_EQ(resumed.exit_code, 3);
  EXPECT_THAT(resumed.output, HasSubstr("a session that stores there is running"));
  const auto ended = session.end();
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_THAT(ended.output, HasSubstr("complete: 6 of 6"));
}

TEST(Interruption, ByMovingTheDataFileIsToldAtOnce) {
  WrittenFiles files;
  files.write("six.json", kSixWords);
  StartedCommand session{files.folder(), "bimodal", run_of("P01", "6")};
  ASSERT_TRUE(session.await("trial 2 of 6"));
  std::filesystem::rename(files.folder() / "x.sqlite", files.folder() / "y.sqlite");
  const auto ended = session.end();
  EXPECT_EQ(ended.exit_code, 5);
  EXPECT_THAT(ended.output, HasSubstr("'x.sqlite' was moved or deleted while the session ran"));
}

}  // namespace
}  // namespace bimodal

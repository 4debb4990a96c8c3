// Data files and folders that cannot or must not be written to.

#include <sqlite3.h>

#include "runner/store/session_store.hpp"
#include "runner/store/stored_session.hpp"
#include "stimuli/base/digest.hpp"
#include "tests/cli/command_line.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

using DataFile = CommandLine;

TEST_F(DataFile, DataFileThatIsNotThereIsNamedByTheAnalysis) {
  const auto run = run_command(
      files_.folder(), "bimodal-analysis", {"report", "nowhere.sqlite", "-o", path("report")});
  EXPECT_THAT(run.output, HasSubstr("nowhere.sqlite"));
  EXPECT_THAT(run.exit_code, testing::AnyOf(3, 5));
  EXPECT_FALSE(std::filesystem::exists(path("report/report.html")));
}

TEST_F(DataFile, DataFileOfANewerSchemaIsRefusedByAllAndLeftAsItIs) {
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

TEST_F(DataFile, FileThatIsNoDataFileIsRefusedAndLeftAsItIs) {
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

TEST_F(DataFile, FolderThatCannotBeWrittenToIsNamed) {
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

TEST_F(DataFile, ReportThatCannotBeWrittenIsNamed) {
  ASSERT_EQ(bimodal({"rehearse", "two.json", "--data", "x.sqlite"}).exit_code, 0);
  EXPECT_THAT(
      run_command(
          files_.folder(), "bimodal-analysis", {"report", "x.sqlite", "-o", "two.json/report"}),
      ended(ExitCode::InvalidInput, AllOf(HasSubstr("two.json/report"), HasSubstr("-o"))));
}

TEST_F(DataFile, SimulatedParticipantsAreNotRepeatedByMistakeEither) {
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

TEST_F(DataFile, EmptyDataFileBecomesPrivate) {
  files_.write("empty.sqlite", "");
  std::filesystem::permissions(path("empty.sqlite"), std::filesystem::perms{0644});
  ASSERT_EQ(bimodal({"rehearse", "two.json", "--data", "empty.sqlite"}).exit_code, 0);
  EXPECT_EQ(std::filesystem::status(path("empty.sqlite")).permissions(),
            std::filesystem::perms{0600});
}

TEST_F(DataFile, SessionThatAParticipantHasAlreadyIsNotRepeatedByMistake) {
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

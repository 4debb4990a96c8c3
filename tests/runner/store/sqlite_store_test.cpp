#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include "runner/store/schema.hpp"
#include "runner/store/session_store.hpp"
#include "runner/store/store_error.hpp"
#include "runner/store/stored_session.hpp"
#include "tests/runner/store/sqlite_fixture.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

TEST_F(SqliteStoreTest, ReadsBackEverythingThatWasStored) {
  {
    const auto store = open_sqlite_store(file_);
    const auto id = store->begin(session(), plan());
    store->add(id, trial(0));
    store->end(id, "stopped", "2026-01-01T01:00:00Z");
  }
  const auto sessions = read_sessions(file_, Detail::Everything);
  ASSERT_EQ(sessions.size(), 1U);
  EXPECT_EQ(sessions[0].outcome, "stopped");
  EXPECT_EQ(sessions[0].planned_trials, 2);
  EXPECT_EQ(sessions[0].session.seed, session().seed);
  EXPECT_EQ(sessions[0].session.refresh_period, 16'666'667ns);
  ASSERT_EQ(sessions[0].trials.size(), 1U);
  const auto& stored = sessions[0].trials[0];
  EXPECT_EQ(stored.plan.snr_db, -8.0);
  EXPECT_EQ(stored.plan.noise_seed, plan()[0].noise_seed);
  EXPECT_EQ(stored.trial.response.text, trial(0).response.text);
  EXPECT_EQ(stored.trial.refreshes.shown, trial(0).refreshes.shown);
  ASSERT_EQ(stored.trial.onsets.size(), 2U);
  EXPECT_EQ(stored.trial.onsets[0].reported, std::nullopt);  // auditory comes first
  EXPECT_EQ(stored.trial.onsets[1].reported, 5s + 1ms);
  EXPECT_EQ(stored.trial.sound->noise_dbfs, -18.0);
  EXPECT_EQ(stored.trial.keystrokes.size(), 2U);
  EXPECT_EQ(stored.trial.events.at(0).kind, "late_frame");
}

TEST_F(SqliteStoreTest, ReadsBackHowTheFaceWasDrawn) {
  auto fast = session();
  fast.face = FaceDrawingRecord{.quality = "fast",
                                .basis = "measured",
                                .full_picture = 123'456'789ns,
                                .renderer = "a card, OpenGL 4.6"};
  auto full = session();
  full.face = FaceDrawingRecord{.quality = "full", .basis = "protocol", .renderer = "x"};
  {
    const auto store = open_sqlite_store(file_);
    for (const auto& one : {fast, full, session()}) static_cast<void>(store->begin(one, plan()));
  }
  const auto sessions = read_sessions(file_);
  ASSERT_EQ(sessions.size(), 3U);
  const auto& read = sessions[0].session.face;
  ASSERT_TRUE(read);
  EXPECT_EQ(read->quality, "fast");
  EXPECT_EQ(read->basis, "measured");
  EXPECT_EQ(read->full_picture, 123'456'789ns);
  EXPECT_EQ(read->renderer, "a card, OpenGL 4.6");
  ASSERT_TRUE(sessions[1].session.face);
  EXPECT_EQ(sessions[1].session.face->full_picture, std::nullopt);
  EXPECT_FALSE(sessions[2].session.face);
}

TEST_F(SqliteStoreTest, ReadsBackWhichRecordingWasShownAndWhichOfItsFrames) {
  {
    const auto store = open_sqlite_store(file_);
    auto with_corpus = session();
    with_corpus.cast = R"({"without": ["V_nat"]})";
    auto dubbed = plan();
    dubbed[0].visual_word = "do";
    dubbed[0].articulation = "D~G:1/4 UW";
    dubbed[0].face = R"({"view":"side"})";
    store->add(store->begin(with_corpus, dubbed), trial(0));
  }
  const auto sessions = read_sessions(file_, Detail::Everything);
  EXPECT_EQ(sessions[0].session.cast, R"({"without": ["V_nat"]})");
  const auto& stored = sessions[0].trials[0];
  EXPECT_EQ(stored.plan.visual_word, "do");
  EXPECT_EQ(stored.plan.articulation, "D~G:1/4 UW");
  EXPECT_EQ(stored.plan.face, R"({"view":"side"})");
  EXPECT_EQ(stored.trial.refreshes.source_frame, (std::vector<std::int64_t>{31, -1}));
  ASSERT_EQ(stored.trial.recordings.size(), 1U);
  EXPECT_EQ(stored.trial.recordings[0].item, "stew-2");
  EXPECT_EQ(stored.trial.recordings[0].end, 13s);
}

/// A file as the first version of the program left it.
void make_version_1(const std::filesystem::path& file) {
  sqlite3* raw = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &raw), SQLITE_OK);
  const auto run = [raw](const std::string& sql) {
    ASSERT_EQ(sqlite3_exec(raw, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(raw);
  };
  run(kVersion1);
  run("PRAGMA application_id = " + std::to_string(kApplicationId));
  run("PRAGMA user_version = 1");
  run("INSERT INTO protocol VALUES ('f00', 'old', '{}')");
  run("INSERT INTO session VALUES (1, 'P01', 1, 1, 'f00', '7', '0.1', 0, 0, '', '2026', NULL, "
      "'complete', 'sdl', '', '', 'none', '', '', 16, 0, 100)");
  run("INSERT INTO plan VALUES (1, 0, 'main', 0, 'stew', 'S T UW', 'A', NULL, 'face', NULL, '3')");
  run("INSERT INTO trial VALUES (1, 0, 5, 6, 0, 'stew', 9, NULL, 0, '[0]', '[0]', '[1]')");
  sqlite3_close(raw);
}

TEST_F(SqliteStoreTest, ReadsAFileOfTheFirstVersion) {
  make_version_1(file_);
  const auto sessions = read_sessions(file_, Detail::Everything);
  ASSERT_EQ(sessions.size(), 1U);
  EXPECT_EQ(sessions[0].trials.at(0).trial.response.text, "stew");
  EXPECT_EQ(sessions[0].trials[0].plan.visual_word, std::nullopt);
  EXPECT_EQ(sessions[0].trials[0].plan.articulation, std::nullopt);
  EXPECT_EQ(sessions[0].trials[0].plan.face, std::nullopt);
  EXPECT_TRUE(sessions[0].session.cast.empty());
  EXPECT_FALSE(sessions[0].session.face);
  EXPECT_FALSE(sessions[0].session.timing);
  EXPECT_FALSE(sessions[0].trials[0].trial.excluded);
  EXPECT_TRUE(sessions[0].trials[0].trial.response.reference.empty());
}

TEST_F(SqliteStoreTest, KeepsWhatTheTimingRestsOn) {
  {
    const auto store = open_sqlite_store(file_);
    auto timed = session();
    timed.timing = TimingRecord{.verdict = "usable",
                                .gate = R"({"flips":120})",
                                .calibration = "{}",
                                .visual_line = "mouth",
                                .visual_line_after = 8ms};
    timed.keyboard_description = "evdev";
    timed.sound_levels = R"({"speech_dbspl":65})";
    const auto id = store->begin(timed, plan());
    auto first = trial(0);
    first.excluded = true;
    first.response.reference = "sound_onset";
    first.response.reference_at = 7s;
    first.response.uncertainty = 1ms;
    first.keystrokes = {{.at = 8s, .source = "poll", .key = "b", .uncertainty = 1ms},
                        {.at = 9s, .source = "poll", .key = "Pointer", .x = 0.25, .y = 0.5}};
    first.clock_maps = {{.clock = "sound",
                         .source = "stream_time",
                         .at = 3s,
                         .device_at = 48'000,
                         .nanoseconds_per_unit = 20'833.3,
                         .drift_ppm = -3.5,
                         .residual = 20us,
                         .readings = 1024,
                         .rejected = 3,
                         .jumps = 1}};
    first.triggers = {{.kind = "serial",
                       .event = "auditory_zero",
                       .code = 17,
                       .planned = 4s,
                       .sent = 4s + 20us,
                       .uncertainty = 15us,
                       .source = "write_returned"}};
    store->add(id, first);
    auto again = plan()[0];
    again.trial = 9;
    again.repeats = 0;
    store->add(id, again);
    store->add(id, trial(9));
  }
  const auto stored = read_sessions(file_, Detail::Everything).at(0);
  ASSERT_TRUE(stored.session.timing);
  EXPECT_EQ(stored.session.timing->verdict, "usable");
  EXPECT_EQ(stored.session.timing->visual_line_after, 8ms);
  EXPECT_EQ(stored.session.keyboard_description, "evdev");
  EXPECT_EQ(stored.session.sound_levels, R"({"speech_dbspl":65})");
  ASSERT_EQ(stored.trials.size(), 2U);
  const auto& first = stored.trials[0].trial;
  EXPECT_TRUE(first.excluded);
  EXPECT_EQ(first.response.reference, "sound_onset");
  EXPECT_EQ(first.response.reference_at, 7s);
  EXPECT_EQ(first.keystrokes.at(0).uncertainty, 1ms);
  EXPECT_EQ(first.keystrokes.at(1).x, 0.25);
  EXPECT_EQ(first.clock_maps.at(0).device_at, 48'000);
  EXPECT_EQ(first.clock_maps[0].drift_ppm, -3.5);
  EXPECT_EQ(first.triggers.at(0).code, 17);
  EXPECT_EQ(first.triggers[0].sent, 4s + 20us);
  EXPECT_EQ(stored.trials[1].plan.repeats, 0);
}

TEST_F(SqliteStoreTest, RaisesAFileOfTheFirstVersionAndKeepsWhatItHolds) {
  make_version_1(file_);
  {
    const auto store = open_sqlite_store(file_);
    store->add(store->begin(session(), plan()), trial(0));
  }
  const auto sessions = read_sessions(file_, Detail::Everything);
  ASSERT_EQ(sessions.size(), 2U);
  EXPECT_EQ(sessions[0].trials.at(0).trial.response.text, "stew");
  EXPECT_EQ(sessions[0].trials[0].trial.refreshes.shown.at(0), 6ns);
  EXPECT_EQ(sessions[1].trials.at(0).trial.recordings.size(), 1U);
}

TEST_F(SqliteStoreTest, AppendsToAnExistingFile) {
  for (int run = 0; run < 2; ++run) {
    const auto store = open_sqlite_store(file_);
    store->add(store->begin(session(), plan()), trial(1));
  }
  EXPECT_EQ(read_sessions(file_).size(), 2U);
}

TEST_F(SqliteStoreTest, TakesUpASessionThatWasStopped) {
  const auto store = open_sqlite_store(file_);
  const auto id = store->begin(session(), plan());
  store->add(id, trial(0));
  store->end(id, "stopped", "2026");
  store->reopen(id);
  EXPECT_EQ(read_sessions(file_).at(0).outcome, "");
  EXPECT_EQ(read_sessions(file_).at(0).trials.size(), 1U);
  store->add(id, trial(1));
  store->end(id, "complete", "2026");
  EXPECT_EQ(read_sessions(file_).at(0).outcome, "complete");
}

TEST_F(SqliteStoreTest, TellsWhatWasPlannedWithoutRepetitions) {
  const auto store = open_sqlite_store(file_);
  const auto id = store->begin(session(), plan());
  auto again = plan()[1];
  again.trial = 9;
  again.repeats = 1;
  store->add(id, again);
  const auto planned = read_plan(file_, id);
  ASSERT_EQ(planned.size(), plan().size());
  for (std::size_t i = 0; i < planned.size(); ++i) {
    EXPECT_EQ(planned[i].trial, plan()[i].trial);
    EXPECT_EQ(planned[i].word, plan()[i].word);
    EXPECT_EQ(planned[i].condition, plan()[i].condition);
    EXPECT_EQ(planned[i].noise_seed, plan()[i].noise_seed);
  }
  EXPECT_EQ(read_sessions(file_).at(0).planned_trials, static_cast<int>(plan().size()));
}

TEST_F(SqliteStoreTest, IsReadableByItsOwnerOnly) {
  const auto store = open_sqlite_store(file_);
  store->begin(session(), plan());
  for (const auto& entry : std::filesystem::directory_iterator{folder_}) {
    struct stat status {};

    ASSERT_EQ(::stat(entry.path().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0600U) << entry.path();
  }
}

TEST_F(SqliteStoreTest, ATrialIsThereForAnotherReaderAsSoonAsAddReturns) {
  const auto store = open_sqlite_store(file_);
  const auto id = store->begin(session(), plan());
  store->add(id, trial(0));
  EXPECT_EQ(read_sessions(file_).at(0).trials.size(), 1U);
}

TEST_F(SqliteStoreTest, RefusesATrialThatWasNotPlannedAndKeepsNothingOfIt) {
  const auto store = open_sqlite_store(file_);
  const auto id = store->begin(session(), plan());
  EXPECT_THROW(store->add(id, trial(7)), StoreError);
  EXPECT_TRUE(read_sessions(file_).at(0).trials.empty());
}

TEST_F(SqliteStoreTest, RefusesToStoreATrialTwice) {
  const auto store = open_sqlite_store(file_);
  const auto id = store->begin(session(), plan());
  store->add(id, trial(0));
  EXPECT_THROW(store->add(id, trial(0)), StoreError);
  EXPECT_EQ(read_sessions(file_, Detail::Everything).at(0).trials.at(0).trial.keystrokes.size(),
            2U);
}

TEST_F(SqliteStoreTest, RefusesAFileOfANewerSchemaAndSaysWhatToDo) {
  static_cast<void>(open_sqlite_store(file_));
  sqlite3* raw = nullptr;
  ASSERT_EQ(sqlite3_open(file_.c_str(), &raw), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(raw, "PRAGMA user_version = 99", nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(raw);
  EXPECT_THAT(refusal(), HasSubstr("schema version 99"));
  EXPECT_THAT(refusal(), HasSubstr("update bimodal"));
  EXPECT_THROW(static_cast<void>(read_sessions(file_)), StoreError);
}

TEST_F(SqliteStoreTest, RefusesAFileOfAnotherProgramAndLeavesItAlone) {
  std::ofstream{file_} << "participant,answer\nP01,ba\n";
  EXPECT_THAT(refusal(), HasSubstr("data.sqlite"));
  EXPECT_EQ(std::filesystem::file_size(file_), 26U);
}

TEST_F(SqliteStoreTest, NamesAFolderThatCannotBeWrittenTo) {
  file_ = folder_ / "missing" / "data.sqlite";
  EXPECT_THAT(refusal(), HasSubstr("--data"));
}

}  // namespace
}  // namespace bimodal::runner

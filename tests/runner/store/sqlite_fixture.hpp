#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "runner/store/session_store.hpp"
#include "runner/store/store_error.hpp"
#include "runner/store/stored_session.hpp"

namespace bimodal::runner {

using namespace std::chrono_literals;

class SqliteStoreTest : public testing::Test {
 protected:
  SqliteStoreTest() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }

  ~SqliteStoreTest() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string refusal() const {
    try {
      static_cast<void>(open_sqlite_store(file_));
    } catch (const StoreError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_ = std::filesystem::path{testing::TempDir()} /
                                  testing::UnitTest::GetInstance()->current_test_info()->name();
  std::filesystem::path file_ = folder_ / "data.sqlite";
  std::filesystem::path log_ = folder_ / "data.sqlite-wal";
};

inline SessionRecord session() {
  return {.participant = "P01",
          .protocol_title = "a test",
          .protocol_text = "{}",
          .protocol_sha256 = "abc",
          .seed = 18'446'744'073'709'551'615U,
          .program_version = "0",
          .started_utc = "2026-01-01T00:00:00Z",
          .display = {"simulated", "d", "predicted"},
          .audio = {"simulated", "a", "predicted"},
          .refresh_period = 16'666'667ns};
}

inline std::vector<PlanRecord> plan() {
  return {{.trial = 0,
           .phase = "main",
           .word = "stew",
           .phones = "S T UW",
           .condition = "bimodal",
           .auditory_talker = "festival:kal",
           .visual_talker = "face",
           .snr_db = -8.0,
           .noise_seed = 9'223'372'036'854'775'809U},
          {.trial = 1, .phase = "main", .word = "bee", .phones = "B IY", .condition = "visual"}};
}

inline std::vector<PlanRecord> planned(int trials) {
  std::vector<PlanRecord> planned;
  for (int i = 0; i < trials; ++i) {
    planned.push_back({.trial = i, .phase = "main", .word = "bee", .condition = "visual"});
  }
  return planned;
}

inline TrialRecord trial(int number) {
  TrialRecord record;
  record.trial = number;
  record.stimulus_start = 5s;
  record.stimulus_end = 6s;
  record.onsets = {{"visual", 5s, 5s + 1ms, "swap_returned"},
                   {"auditory", 5s, std::nullopt, "none"}};
  record.sound = SoundRecord{.sha256 = "f00", .rate_hz = 48'000, .samples = 3, .noise_dbfs = -18.0};
  record.refreshes = {.frame = {0, 1},
                      .source_frame = {31, -1},
                      .planned = {5s, 5s + 16ms},
                      .shown = {5s + 1ms, 5s + 17ms}};
  record.recordings = {{.modality = "visual",
                        .talker = "corpus:natural",
                        .item = "stew-2",
                        .file = "media/one.mp4",
                        .sha256 = "f00",
                        .start = 12s,
                        .end = 13s}};
  record.response = {.text = "st\xc3\xbc 'DROP TABLE", .submitted = 8s, .first_key = 7s};
  record.keystrokes = {{7s, "poll", "s"}, {8s, "poll", "Enter"}};
  record.events = {{5s, "late_frame", "2 refreshes"}};
  record.flagged = true;
  return record;
}

}  // namespace bimodal::runner

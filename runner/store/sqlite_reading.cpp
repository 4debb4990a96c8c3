#include <charconv>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "runner/store/schema_check.hpp"
#include "runner/store/sqlite.hpp"
#include "runner/store/store_error.hpp"
#include "runner/store/stored_session.hpp"

namespace bimodal::runner {

namespace {

std::uint64_t unsigned_from(const std::string& digits) {
  std::uint64_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

std::optional<std::string> optional_text(const Statement& row, int column) {
  if (row.is_null(column)) return std::nullopt;
  return row.text(column);
}

std::optional<double> optional_real(const Statement& row, int column) {
  if (row.is_null(column)) return std::nullopt;
  return row.real(column);
}

std::optional<Duration> optional_duration(const Statement& row, int column) {
  if (row.is_null(column)) return std::nullopt;
  return row.duration(column);
}

std::vector<std::int64_t> numbers_from(const std::string& json) {
  const auto parsed = nlohmann::json::parse(json, nullptr, false);
  if (!parsed.is_array()) throw StoreError{"a list of refreshes in the data file is damaged"};
  return parsed.get<std::vector<std::int64_t>>();
}

std::vector<Duration> instants_from(const std::string& json, Duration origin) {
  std::vector<Duration> instants;
  for (const auto since : numbers_from(json)) instants.push_back(origin + Duration{since});
  return instants;
}

StoredSession session_from(const Statement& row) {
  StoredSession stored;
  auto& session = stored.session;
  session.id = row.integer(0);
  session.participant = row.text(1);
  session.participant_number = static_cast<int>(row.integer(2));
  session.session_number = static_cast<int>(row.integer(3));
  session.protocol_sha256 = row.text(4);
  session.protocol_title = row.text(5);
  session.protocol_text = row.text(6);
  session.seed = unsigned_from(row.text(7));
  session.program_version = row.text(8);
  session.simulated_answers = row.integer(9) != 0;
  session.simulated_time = row.integer(10) != 0;
  session.observer = row.text(11);
  session.started_utc = row.text(12);
  stored.outcome = row.text(13);
  session.display = {row.text(14), row.text(15), row.text(16)};
  session.audio = {row.text(17), row.text(18), row.text(19)};
  session.refresh_period = row.duration(20);
  session.refresh_deviation = row.duration(21);
  session.refresh_count = static_cast<int>(row.integer(22));
  stored.planned_trials = static_cast<int>(row.integer(23));
  stored.shortened = row.integer(24) != 0;
  session.cast = row.text(25);
  if (!row.is_null(26)) {
    session.face = FaceDrawingRecord{.quality = row.text(26),
                                     .basis = row.text(27),
                                     .full_picture = optional_duration(row, 28),
                                     .renderer = row.text(29)};
  }
  if (!row.is_null(30)) {
    session.timing = TimingRecord{.verdict = row.text(30),
                                  .gate = row.text(31),
                                  .calibration = row.text(32),
                                  .visual_line = row.text(33),
                                  .visual_line_after = row.duration(34)};
  }
  session.keyboard_description = row.text(35);
  session.sound_levels = row.text(36);
  return stored;
}

StoredTrial trial_from(const Statement& row, Detail detail) {
  StoredTrial stored;
  auto& plan = stored.plan;
  plan.trial = static_cast<int>(row.integer(1));
  plan.phase = row.text(2);
  plan.block = static_cast<int>(row.integer(3));
  plan.word = row.text(4);
  plan.phones = row.text(5);
  plan.condition = row.text(6);
  plan.auditory_talker = optional_text(row, 7);
  plan.visual_talker = optional_text(row, 8);
  plan.snr_db = optional_real(row, 9);
  plan.noise_seed = unsigned_from(row.text(10));
  plan.visual_word = optional_text(row, 21);
  plan.articulation = optional_text(row, 23);
  plan.face = optional_text(row, 24);
  if (!row.is_null(25)) plan.repeats = static_cast<int>(row.integer(25));
  auto& trial = stored.trial;
  trial.trial = plan.trial;
  trial.stimulus_start = row.duration(11);
  trial.stimulus_end = row.duration(12);
  trial.flagged = row.integer(13) != 0;
  trial.response.text = row.text(14);
  trial.response.submitted = row.duration(15);
  trial.response.first_key = optional_duration(row, 16);
  trial.response.timed_out = row.integer(17) != 0;
  trial.excluded = row.integer(26) != 0;
  trial.response.reference = row.text(27);
  trial.response.reference_at = optional_duration(row, 28);
  trial.response.uncertainty = optional_duration(row, 29);
  if (detail == Detail::Everything) {
    trial.refreshes.frame = numbers_from(row.text(18));
    trial.refreshes.planned = instants_from(row.text(19), trial.stimulus_start);
    trial.refreshes.shown = instants_from(row.text(20), trial.stimulus_start);
    if (!row.is_null(22)) trial.refreshes.source_frame = numbers_from(row.text(22));
  }
  return stored;
}

using TrialsById = std::map<std::pair<std::int64_t, std::int64_t>, TrialRecord*>;

void read_onsets(Database& database, const TrialsById& trials) {
  Statement row{database,
                "SELECT session, trial, modality, planned_ns, reported_ns, source FROM onset"};
  while (row.step()) {
    trials.at({row.integer(0), row.integer(1)})
        ->onsets.push_back({row.text(2), row.duration(3), optional_duration(row, 4), row.text(5)});
  }
}

void read_sounds(Database& database, const TrialsById& trials) {
  Statement row{database, "SELECT * FROM sound"};
  while (row.step()) {
    trials.at({row.integer(0), row.integer(1)})->sound =
        SoundRecord{.sha256 = row.text(2),
                    .rate_hz = static_cast<int>(row.integer(3)),
                    .samples = row.integer(4),
                    .speech_dbfs = row.real(5),
                    .noise_dbfs = optional_real(row, 6),
                    .band_low_hz = row.real(7),
                    .band_high_hz = row.real(8),
                    .peak = row.real(9),
                    .speech_start = row.duration(10),
                    .speech_end = row.duration(11)};
  }
}

void read_recordings(Database& database, const TrialsById& trials) {
  Statement row{database,
                "SELECT session, trial, modality, talker, item, file, sha256, start_ns, end_ns"
                " FROM recording"};
  while (row.step()) {
    trials.at({row.integer(0), row.integer(1)})
        ->recordings.push_back({.modality = row.text(2),
                                .talker = row.text(3),
                                .item = row.text(4),
                                .file = row.text(5),
                                .sha256 = row.text(6),
                                .start = row.duration(7),
                                .end = row.duration(8)});
  }
}

void read_keystrokes(Database& database, const TrialsById& trials, bool has_timing) {
  Statement row{database,
                std::string{"SELECT session, trial, at_ns, source, key, "} +
                    (has_timing ? "uncertainty_ns, x, y" : "NULL, NULL, NULL") +
                    " FROM keystroke ORDER BY session, trial, ordinal"};
  while (row.step()) {
    trials.at({row.integer(0), row.integer(1)})
        ->keystrokes.push_back({.at = row.duration(2),
                                .source = row.text(3),
                                .key = row.text(4),
                                .uncertainty = optional_duration(row, 5),
                                .x = optional_real(row, 6),
                                .y = optional_real(row, 7)});
  }
}

void read_clock_maps(Database& database, const TrialsById& trials) {
  Statement row{database,
                "SELECT session, trial, clock, source, at_ns, device_at, ns_per_unit, drift_ppm,"
                " residual_ns, readings, rejected, jumps FROM clock_map"};
  while (row.step()) {
    trials.at({row.integer(0), row.integer(1)})
        ->clock_maps.push_back({.clock = row.text(2),
                                .source = row.text(3),
                                .at = row.duration(4),
                                .device_at = row.integer(5),
                                .nanoseconds_per_unit = row.real(6),
                                .drift_ppm = optional_real(row, 7),
                                .residual = row.duration(8),
                                .readings = row.integer(9),
                                .rejected = row.integer(10),
                                .jumps = static_cast<int>(row.integer(11))});
  }
}

void read_triggers(Database& database, const TrialsById& trials) {
  Statement row{database,
                "SELECT session, trial, kind, event, code, planned_ns, sent_ns, uncertainty_ns,"
                " source FROM trigger ORDER BY session, trial, ordinal"};
  while (row.step()) {
    TriggerRecord trigger{.kind = row.text(2),
                          .event = row.text(3),
                          .planned = row.duration(5),
                          .sent = optional_duration(row, 6),
                          .uncertainty = optional_duration(row, 7),
                          .source = row.text(8)};
    if (!row.is_null(4)) trigger.code = static_cast<int>(row.integer(4));
    trials.at({row.integer(0), row.integer(1)})->triggers.push_back(std::move(trigger));
  }
}

void read_events(Database& database, const TrialsById& trials) {
  Statement row{database,
                "SELECT session, trial, at_ns, kind, detail FROM event WHERE trial IS NOT NULL"};
  while (row.step()) {
    trials.at({row.integer(0), row.integer(1)})
        ->events.push_back({row.duration(2), row.text(3), row.text(4)});
  }
}

}  // namespace

std::vector<PlanRecord> read_plan(const std::filesystem::path& file, std::int64_t session) {
  Database database{file, Database::Access::Read};
  check_schema(database, file.string());
  const bool has_timing = database.pragma("user_version") >= 6;
  Statement row{database,
                std::string{"SELECT trial, phase, block, word, phones, condition, noise_seed"
                            " FROM plan WHERE session = ?"} +
                    (has_timing ? " AND repeats IS NULL" : "") + " ORDER BY trial"};
  row.bind(session);
  std::vector<PlanRecord> plan;
  while (row.step()) {
    plan.push_back({.trial = static_cast<int>(row.integer(0)),
                    .phase = row.text(1),
                    .block = static_cast<int>(row.integer(2)),
                    .word = row.text(3),
                    .phones = row.text(4),
                    .condition = row.text(5),
                    .noise_seed = unsigned_from(row.text(6))});
  }
  return plan;
}

std::size_t next_trial(const std::filesystem::path& file, std::int64_t session) {
  Database database{file, Database::Access::Read};
  check_schema(database, file.string());
  Statement row{database, "SELECT coalesce(max(trial), -1) + 1 FROM plan WHERE session = ?"};
  row.bind(session);
  return row.step() ? static_cast<std::size_t>(row.integer(0)) : 0;
}

std::vector<StoredSession> read_sessions(const std::filesystem::path& file, Detail detail) {
  Database database{file, Database::Access::Read};
  check_schema(database, file.string());
  const auto version = database.pragma("user_version");
  const bool has_recordings = version >= 2;
  const bool has_articulations = version >= 3;
  const bool has_faces = version >= 4;
  const bool has_looks = version >= 5;
  const bool has_timing = version >= 6;

  std::vector<StoredSession> sessions;
  std::map<std::int64_t, std::size_t> position;
  Statement session_row{
      database,
      "SELECT session, participant, participant_number, session_number, protocol_sha256, title, "
      "text,"
      " seed, program_version, simulated_answers, simulated_time, observer, started_utc, outcome,"
      " display_kind, display_description, display_time_source, audio_kind, audio_description,"
      " audio_time_source, refresh_period_ns, refresh_deviation_ns, refresh_count,"
      " (SELECT count(*) FROM plan WHERE plan.session = session.session" +
          std::string{has_timing ? " AND repeats IS NULL" : ""} +
          "),"
          " EXISTS (SELECT 1 FROM event WHERE event.session = session.session AND kind = "
          "'shortened'), " +
          std::string{has_recordings ? "casting, " : "'', "} +
          std::string{has_faces ? "face_quality, face_quality_basis, face_full_picture_ns, "
                                  "face_renderer"
                                : "NULL, NULL, NULL, NULL"} +
          (has_timing ? ", timing_verdict, timing_gate, timing_calibration, visual_line, "
                        "visual_line_ns, keyboard_description, sound_levels"
                      : ", NULL, NULL, NULL, NULL, NULL, '', NULL") +
          " FROM session JOIN protocol ON sha256 = protocol_sha256 ORDER BY session"};
  while (session_row.step()) {
    position[session_row.integer(0)] = sessions.size();
    sessions.push_back(session_from(session_row));
  }

  Statement trial_row{
      database,
      "SELECT session, trial, phase, block, word, phones, condition, auditory_talker,"
      " visual_talker, snr_db, noise_seed, stimulus_start_ns, stimulus_end_ns, flagged,"
      " response, submitted_ns, first_key_ns, timed_out, refresh_frame,"
      " refresh_planned_ns, refresh_shown_ns, " +
          std::string{has_recordings ? "visual_word, refresh_source_frame" : "NULL, NULL"} +
          std::string{has_articulations ? ", articulation" : ", NULL"} +
          std::string{has_looks ? ", face" : ", NULL"} +
          (has_timing ? ", repeats, excluded, rt_reference, rt_reference_ns, rt_uncertainty_ns"
                      : ", NULL, 0, '', NULL, NULL") +
          " FROM trial JOIN plan USING (session, trial)"
          " ORDER BY session, stimulus_start_ns, trial"};
  while (trial_row.step()) {
    sessions.at(position.at(trial_row.integer(0))).trials.push_back(trial_from(trial_row, detail));
  }
  if (detail == Detail::Responses) return sessions;

  TrialsById trials;
  for (auto& session : sessions) {
    for (auto& stored : session.trials) {
      trials[{session.session.id, stored.trial.trial}] = &stored.trial;
    }
  }
  read_onsets(database, trials);
  read_sounds(database, trials);
  if (has_recordings) read_recordings(database, trials);
  read_keystrokes(database, trials, has_timing);
  if (has_timing) read_clock_maps(database, trials);
  if (has_timing) read_triggers(database, trials);
  read_events(database, trials);
  return sessions;
}

}  // namespace bimodal::runner

#include <charconv>
#include <map>
#include <utility>

#include "runner/store/number_lists.hpp"
#include "runner/store/schema_check.hpp"
#include "runner/store/sqlite.hpp"
#include "runner/store/sqlite_trial_parts.hpp"
#include "runner/store/store_error.hpp"
#include "runner/store/stored_session.hpp"

namespace bimodal::runner {

namespace {

std::uint64_t unsigned_from(const std::string& digits) {
  std::uint64_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
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
                                     .full_picture = row.optional_duration(28),
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
  plan.auditory_talker = row.optional_text(7);
  plan.visual_talker = row.optional_text(8);
  plan.snr_db = row.optional_real(9);
  plan.noise_seed = unsigned_from(row.text(10));
  plan.visual_word = row.optional_text(21);
  plan.articulation = row.optional_text(23);
  plan.face = row.optional_text(24);
  if (!row.is_null(25)) plan.repeats = static_cast<int>(row.integer(25));
  auto& trial = stored.trial;
  trial.trial = plan.trial;
  trial.stimulus_start = row.duration(11);
  trial.stimulus_end = row.duration(12);
  trial.flagged = row.integer(13) != 0;
  trial.response.text = row.text(14);
  trial.response.submitted = row.duration(15);
  trial.response.first_key = row.optional_duration(16);
  trial.response.timed_out = row.integer(17) != 0;
  trial.excluded = row.integer(26) != 0;
  trial.response.reference = row.text(27);
  trial.response.reference_at = row.optional_duration(28);
  trial.response.uncertainty = row.optional_duration(29);
  if (detail == Detail::Everything) {
    trial.refreshes.frame = numbers_from(row.text(18));
    trial.refreshes.planned = instants_from(row.text(19), trial.stimulus_start);
    trial.refreshes.shown = instants_from(row.text(20), trial.stimulus_start);
    if (!row.is_null(22)) trial.refreshes.source_frame = numbers_from(row.text(22));
  }
  return stored;
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
  read_trial_parts(database, version, trials);
  return sessions;
}

}  // namespace bimodal::runner

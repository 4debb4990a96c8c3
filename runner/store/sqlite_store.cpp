#include <algorithm>
#include <mutex>
#include <string>

#include "runner/store/number_lists.hpp"
#include "runner/store/schema_check.hpp"
#include "runner/store/session_store.hpp"
#include "runner/store/sqlite.hpp"
#include "runner/store/store_error.hpp"

namespace bimodal::runner {

namespace {

class SqliteStore final : public SessionStore {
 public:
  explicit SqliteStore(const std::filesystem::path& file)
      : database_{file, Database::Access::Write}, schema_{database_, file.string()} {}

  std::int64_t begin(const SessionRecord& session, std::span<const PlanRecord> plan) override {
    const std::lock_guard lock{mutex_};
    Transaction transaction{database_};
    insert_protocol_.reset()
        .bind(session.protocol_sha256)
        .bind(session.protocol_title)
        .bind(session.protocol_text)
        .run();
    insert_session(session);
    const auto id = database_.last_row();
    for (const auto& planned : plan) insert_plan(id, planned);
    transaction.commit();
    database_.empty_log();  // the file alone says from now on what it is
    return id;
  }

  void add(std::int64_t session, const TrialRecord& trial) override {
    const std::lock_guard lock{mutex_};
    database_.require_in_place();
    Transaction transaction{database_};
    insert_trial(session, trial);
    for (const auto& onset : trial.onsets) {
      insert_onset_.reset()
          .bind(session)
          .bind(trial.trial)
          .bind(onset.modality)
          .bind(onset.planned)
          .bind(onset.reported)
          .bind(onset.source)
          .run();
    }
    if (trial.sound) insert_sound(session, trial.trial, *trial.sound);
    for (const auto& recording : trial.recordings) {
      insert_recording(session, trial.trial, recording);
    }
    int ordinal = 0;
    for (const auto& stroke : trial.keystrokes) {
      insert_keystroke_.reset()
          .bind(session)
          .bind(trial.trial)
          .bind(ordinal++)
          .bind(stroke.at)
          .bind(stroke.source)
          .bind(stroke.key)
          .bind(stroke.uncertainty)
          .bind(stroke.x)
          .bind(stroke.y)
          .run();
    }
    for (const auto& map : trial.clock_maps) insert_clock_map(session, trial.trial, map);
    int signal = 0;
    for (const auto& trigger : trial.triggers) {
      insert_trigger(session, trial.trial, signal++, trigger);
    }
    for (const auto& event : trial.events) insert_event(session, trial.trial, event);
    transaction.commit();
  }

  void add(std::int64_t session, const PlanRecord& planned) override {
    const std::lock_guard lock{mutex_};
    insert_plan(session, planned);
  }

  void add(std::int64_t session, const EventRecord& event) override {
    const std::lock_guard lock{mutex_};
    insert_event(session, std::nullopt, event);
  }

  void reopen(std::int64_t session) override {
    const std::lock_guard lock{mutex_};
    reopen_session_.reset().bind(session).run();
  }

  void end(std::int64_t session, std::string_view outcome, std::string_view ended_utc) override {
    const std::lock_guard lock{mutex_};
    end_session_.reset().bind(outcome).bind(ended_utc).bind(session).run();
  }

  void settle() override {
    constexpr int kMuch = 160;  // pages, those of about 20 trials
    const std::lock_guard lock{mutex_};
    if (database_.log_pages() >= kMuch) database_.empty_log();
  }

 private:
  /// Runs before the statements below are prepared, for they need the tables.
  struct Schema {
    Schema(Database& database, const std::string& file) { prepare_schema(database, file); }
  };

  void insert_session(const SessionRecord& session) {
    std::optional<std::string> quality;
    std::optional<std::string> basis;
    std::optional<Duration> full_picture;
    std::optional<std::string> renderer;
    if (session.face) {
      quality = session.face->quality;
      basis = session.face->basis;
      full_picture = session.face->full_picture;
      renderer = session.face->renderer;
    }
    const auto& timing = session.timing;
    insert_session_.reset()
        .bind(session.participant)
        .bind(session.participant_number)
        .bind(session.session_number)
        .bind(session.protocol_sha256)
        .bind(std::to_string(session.seed))
        .bind(session.program_version)
        .bind(session.simulated_answers)
        .bind(session.simulated_time)
        .bind(session.observer)
        .bind(session.started_utc)
        .bind(session.display.kind)
        .bind(session.display.description)
        .bind(session.display.time_source)
        .bind(session.audio.kind)
        .bind(session.audio.description)
        .bind(session.audio.time_source)
        .bind(session.refresh_period)
        .bind(session.refresh_deviation)
        .bind(session.refresh_count)
        .bind(session.cast)
        .bind(quality)
        .bind(basis)
        .bind(full_picture)
        .bind(renderer)
        .bind(timing ? std::optional{timing->verdict} : std::nullopt)
        .bind(timing ? std::optional{timing->gate} : std::nullopt)
        .bind(timing && !timing->calibration.empty() ? std::optional{timing->calibration}
                                                     : std::nullopt)
        .bind(session.keyboard_description)
        .bind(timing ? std::optional{timing->visual_line} : std::nullopt)
        .bind(timing ? std::optional{timing->visual_line_after} : std::nullopt)
        .bind(session.sound_levels.empty() ? std::nullopt : std::optional{session.sound_levels})
        .run();
  }

  void insert_plan(std::int64_t session, const PlanRecord& planned) {
    insert_plan_.reset()
        .bind(session)
        .bind(planned.trial)
        .bind(planned.phase)
        .bind(planned.block)
        .bind(planned.word)
        .bind(planned.phones)
        .bind(planned.condition)
        .bind(planned.auditory_talker)
        .bind(planned.visual_talker)
        .bind(planned.snr_db)
        .bind(std::to_string(planned.noise_seed))
        .bind(planned.visual_word)
        .bind(planned.articulation)
        .bind(planned.face)
        .bind(planned.repeats)
        .run();
  }

  void insert_trial(std::int64_t session, const TrialRecord& trial) {
    insert_trial_.reset()
        .bind(session)
        .bind(trial.trial)
        .bind(trial.stimulus_start)
        .bind(trial.stimulus_end)
        .bind(trial.flagged)
        .bind(trial.response.text)
        .bind(trial.response.submitted)
        .bind(trial.response.first_key)
        .bind(trial.response.timed_out)
        .bind(as_json(trial.refreshes.frame))
        .bind(as_json(trial.refreshes.planned, trial.stimulus_start))
        .bind(as_json(trial.refreshes.shown, trial.stimulus_start))
        .bind(source_frames(trial.refreshes))
        .bind(trial.excluded)
        .bind(trial.response.reference.empty() ? std::nullopt
                                               : std::optional{trial.response.reference})
        .bind(trial.response.reference_at)
        .bind(trial.response.uncertainty)
        .run();
  }

  void insert_clock_map(std::int64_t session, int trial, const ClockMapRecord& map) {
    insert_clock_map_.reset()
        .bind(session)
        .bind(trial)
        .bind(map.clock)
        .bind(map.source)
        .bind(map.at)
        .bind(map.device_at)
        .bind(map.nanoseconds_per_unit)
        .bind(map.drift_ppm)
        .bind(map.residual)
        .bind(map.readings)
        .bind(map.rejected)
        .bind(map.jumps)
        .run();
  }

  void insert_trigger(std::int64_t session, int trial, int ordinal, const TriggerRecord& trigger) {
    insert_trigger_.reset()
        .bind(session)
        .bind(trial)
        .bind(ordinal)
        .bind(trigger.kind)
        .bind(trigger.event)
        .bind(trigger.code)
        .bind(trigger.planned)
        .bind(trigger.sent)
        .bind(trigger.uncertainty)
        .bind(trigger.source)
        .run();
  }

  static std::optional<std::string> source_frames(const RefreshRecord& refreshes) {
    if (refreshes.source_frame.empty()) return std::nullopt;
    return as_json(refreshes.source_frame);
  }

  void insert_recording(std::int64_t session, int trial, const RecordingRecord& recording) {
    insert_recording_.reset()
        .bind(session)
        .bind(trial)
        .bind(recording.modality)
        .bind(recording.talker)
        .bind(recording.item)
        .bind(recording.file)
        .bind(recording.sha256)
        .bind(recording.start)
        .bind(recording.end)
        .run();
  }

  void insert_sound(std::int64_t session, int trial, const SoundRecord& sound) {
    insert_sound_.reset()
        .bind(session)
        .bind(trial)
        .bind(sound.sha256)
        .bind(sound.rate_hz)
        .bind(sound.samples)
        .bind(sound.speech_dbfs)
        .bind(sound.noise_dbfs)
        .bind(sound.band_low_hz)
        .bind(sound.band_high_hz)
        .bind(sound.peak)
        .bind(sound.speech_start)
        .bind(sound.speech_end)
        .run();
  }

  void insert_event(std::int64_t session, std::optional<int> trial, const EventRecord& event) {
    insert_event_.reset()
        .bind(session)
        .bind(trial)
        .bind(event.at)
        .bind(event.kind)
        .bind(event.detail)
        .run();
  }

  std::mutex mutex_;  ///< over all that follows
  Database database_;
  Schema schema_;
  Statement insert_protocol_{
      database_, "INSERT INTO protocol VALUES (?, ?, ?) ON CONFLICT (sha256) DO NOTHING"};
  Statement insert_session_{database_,
                            "INSERT INTO session VALUES (NULL, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, NULL, "
                            "NULL, ?, ?, ?, ?, ?, ?, "
                            "?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"};
  Statement insert_plan_{database_,
                         "INSERT INTO plan VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"};
  Statement insert_trial_{
      database_, "INSERT INTO trial VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"};
  Statement insert_recording_{database_,
                              "INSERT INTO recording VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"};
  Statement insert_onset_{database_, "INSERT INTO onset VALUES (?, ?, ?, ?, ?, ?)"};
  Statement insert_sound_{database_,
                          "INSERT INTO sound VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"};
  Statement insert_keystroke_{database_,
                              "INSERT INTO keystroke VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"};
  Statement insert_clock_map_{database_,
                              "INSERT INTO clock_map VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"};
  Statement insert_trigger_{database_, "INSERT INTO trigger VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"};
  Statement insert_event_{database_, "INSERT INTO event VALUES (NULL, ?, ?, ?, ?, ?)"};
  Statement reopen_session_{
      database_, "UPDATE session SET outcome = NULL, ended_utc = NULL WHERE session = ?"};
  Statement end_session_{database_,
                         "UPDATE session SET outcome = ?, ended_utc = ? WHERE session = ?"};
};

}  // namespace

std::unique_ptr<SessionStore> open_sqlite_store(const std::filesystem::path& file) {
  return std::make_unique<SqliteStore>(file);
}

}  // namespace bimodal::runner

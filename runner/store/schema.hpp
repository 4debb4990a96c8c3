#pragma once

#include <array>

namespace bimodal::runner {

/// What `PRAGMA application_id` of a bimodal file reads: "bimo".
inline constexpr int kApplicationId = 0x62696d6f;

/// `PRAGMA user_version`: raised with every change of the tables; older programs refuse newer
/// files.
inline constexpr int kSchemaVersion = 6;

/// The tables of version 1; explained column by column in SCHEMA.md.
inline constexpr const char* kVersion1 = R"sql(
CREATE TABLE protocol (
  sha256 TEXT PRIMARY KEY,
  title  TEXT NOT NULL,
  text   TEXT NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE session (
  session              INTEGER PRIMARY KEY,
  participant          TEXT NOT NULL,
  participant_number   INTEGER NOT NULL,
  session_number       INTEGER NOT NULL,
  protocol_sha256      TEXT NOT NULL REFERENCES protocol (sha256),
  seed                 TEXT NOT NULL,
  program_version      TEXT NOT NULL,
  simulated_answers    INTEGER NOT NULL CHECK (simulated_answers IN (0, 1)),
  simulated_time       INTEGER NOT NULL CHECK (simulated_time IN (0, 1)),
  observer             TEXT NOT NULL,
  started_utc          TEXT NOT NULL,
  ended_utc            TEXT,
  outcome              TEXT CHECK (outcome IN ('complete', 'stopped')),
  display_kind         TEXT NOT NULL,
  display_description  TEXT NOT NULL,
  display_time_source  TEXT NOT NULL,
  audio_kind           TEXT NOT NULL,
  audio_description    TEXT NOT NULL,
  audio_time_source    TEXT NOT NULL,
  refresh_period_ns    INTEGER NOT NULL,
  refresh_deviation_ns INTEGER NOT NULL,
  refresh_count        INTEGER NOT NULL
) STRICT;

CREATE TABLE plan (
  session         INTEGER NOT NULL REFERENCES session (session),
  trial           INTEGER NOT NULL,
  phase           TEXT NOT NULL CHECK (phase IN ('practice', 'main')),
  block           INTEGER NOT NULL,
  word            TEXT NOT NULL,
  phones          TEXT NOT NULL,
  condition       TEXT NOT NULL,
  auditory_talker TEXT,
  visual_talker   TEXT,
  snr_db          REAL,
  noise_seed      TEXT NOT NULL,
  PRIMARY KEY (session, trial)
) STRICT, WITHOUT ROWID;

CREATE TABLE trial (
  session            INTEGER NOT NULL,
  trial              INTEGER NOT NULL,
  stimulus_start_ns  INTEGER NOT NULL,
  stimulus_end_ns    INTEGER NOT NULL,
  flagged            INTEGER NOT NULL CHECK (flagged IN (0, 1)),
  response           TEXT NOT NULL,
  submitted_ns       INTEGER NOT NULL,
  first_key_ns       INTEGER,
  timed_out          INTEGER NOT NULL CHECK (timed_out IN (0, 1)),
  refresh_frame      TEXT NOT NULL,
  refresh_planned_ns TEXT NOT NULL,
  refresh_shown_ns   TEXT NOT NULL,
  PRIMARY KEY (session, trial),
  FOREIGN KEY (session, trial) REFERENCES plan (session, trial)
) STRICT, WITHOUT ROWID;

CREATE TABLE onset (
  session     INTEGER NOT NULL,
  trial       INTEGER NOT NULL,
  modality    TEXT NOT NULL CHECK (modality IN ('auditory', 'visual')),
  planned_ns  INTEGER NOT NULL,
  reported_ns INTEGER,
  source      TEXT NOT NULL,
  PRIMARY KEY (session, trial, modality),
  FOREIGN KEY (session, trial) REFERENCES trial (session, trial)
) STRICT, WITHOUT ROWID;

CREATE TABLE sound (
  session         INTEGER NOT NULL,
  trial           INTEGER NOT NULL,
  sha256          TEXT NOT NULL,
  rate_hz         INTEGER NOT NULL,
  samples         INTEGER NOT NULL,
  speech_dbfs     REAL NOT NULL,
  noise_dbfs      REAL,
  band_low_hz     REAL NOT NULL,
  band_high_hz    REAL NOT NULL,
  peak            REAL NOT NULL,
  speech_start_ns INTEGER NOT NULL,
  speech_end_ns   INTEGER NOT NULL,
  PRIMARY KEY (session, trial),
  FOREIGN KEY (session, trial) REFERENCES trial (session, trial)
) STRICT, WITHOUT ROWID;

CREATE TABLE keystroke (
  session INTEGER NOT NULL,
  trial   INTEGER NOT NULL,
  ordinal INTEGER NOT NULL,
  at_ns   INTEGER NOT NULL,
  source  TEXT NOT NULL,
  key     TEXT NOT NULL,
  PRIMARY KEY (session, trial, ordinal),
  FOREIGN KEY (session, trial) REFERENCES trial (session, trial)
) STRICT, WITHOUT ROWID;

CREATE TABLE event (
  event   INTEGER PRIMARY KEY,
  session INTEGER NOT NULL REFERENCES session (session),
  trial   INTEGER,
  at_ns   INTEGER NOT NULL,
  kind    TEXT NOT NULL,
  detail  TEXT NOT NULL
) STRICT;

CREATE VIEW answers AS
  SELECT s.participant, s.session, p.trial, p.phase, p.block, p.condition, p.auditory_talker,
         p.visual_talker, p.snr_db, p.word, p.phones, t.response, t.timed_out, t.flagged,
         (t.submitted_ns - t.stimulus_end_ns) / 1e6 AS rt_ms,
         s.simulated_answers, s.simulated_time
  FROM trial t JOIN plan p USING (session, trial) JOIN session s USING (session);
)sql";

/// From version 1 to 2: natural talkers. Columns stand at the end, so that a file that was raised
/// and one that was made new are alike.
inline constexpr const char* kVersion2 = R"sql(
ALTER TABLE session ADD COLUMN casting TEXT NOT NULL DEFAULT '';
ALTER TABLE plan ADD COLUMN visual_word TEXT;
ALTER TABLE trial ADD COLUMN refresh_source_frame TEXT;

CREATE TABLE recording (
  session  INTEGER NOT NULL,
  trial    INTEGER NOT NULL,
  modality TEXT NOT NULL CHECK (modality IN ('auditory', 'visual')),
  talker   TEXT NOT NULL,
  item     TEXT NOT NULL,
  file     TEXT NOT NULL,
  sha256   TEXT NOT NULL,
  start_ns INTEGER NOT NULL,
  end_ns   INTEGER NOT NULL,
  PRIMARY KEY (session, trial, modality),
  FOREIGN KEY (session, trial) REFERENCES trial (session, trial)
) STRICT, WITHOUT ROWID;

DROP VIEW answers;
CREATE VIEW answers AS
  SELECT s.participant, s.session, p.trial, p.phase, p.block, p.condition, p.auditory_talker,
         p.visual_talker, p.snr_db, p.word, p.phones, t.response, t.timed_out, t.flagged,
         (t.submitted_ns - t.stimulus_end_ns) / 1e6 AS rt_ms,
         s.simulated_answers, s.simulated_time, p.visual_word
  FROM trial t JOIN plan p USING (session, trial) JOIN session s USING (session);
)sql";

/// From version 2 to 3: ambiguous sounds, seen but not heard.
inline constexpr const char* kVersion3 = R"sql(
ALTER TABLE plan ADD COLUMN articulation TEXT;

DROP VIEW answers;
CREATE VIEW answers AS
  SELECT s.participant, s.session, p.trial, p.phase, p.block, p.condition, p.auditory_talker,
         p.visual_talker, p.snr_db, p.word, p.phones, t.response, t.timed_out, t.flagged,
         (t.submitted_ns - t.stimulus_end_ns) / 1e6 AS rt_ms,
         s.simulated_answers, s.simulated_time, p.visual_word, p.articulation
  FROM trial t JOIN plan p USING (session, trial) JOIN session s USING (session);
)sql";

/// From version 3 to 4: how the synthetic face was drawn.
inline constexpr const char* kVersion4 = R"sql(
ALTER TABLE session ADD COLUMN face_quality TEXT CHECK (face_quality IN ('fast', 'full'));
ALTER TABLE session ADD COLUMN face_quality_basis TEXT;
ALTER TABLE session ADD COLUMN face_full_picture_ns INTEGER;
ALTER TABLE session ADD COLUMN face_renderer TEXT;
)sql";

/// From version 4 to 5: what the synthetic face looked like.
inline constexpr const char* kVersion5 = R"sql(
ALTER TABLE plan ADD COLUMN face TEXT;

DROP VIEW answers;
CREATE VIEW answers AS
  SELECT s.participant, s.session, p.trial, p.phase, p.block, p.condition, p.auditory_talker,
         p.visual_talker, p.snr_db, p.word, p.phones, t.response, t.timed_out, t.flagged,
         (t.submitted_ns - t.stimulus_end_ns) / 1e6 AS rt_ms,
         s.simulated_answers, s.simulated_time, p.visual_word, p.articulation, p.face
  FROM trial t JOIN plan p USING (session, trial) JOIN session s USING (session);
)sql";

/// From version 5 to 6: what the timing rests on, triggers, repeated trials, pointers.
inline constexpr const char* kVersion6 = R"sql(
ALTER TABLE session ADD COLUMN timing_verdict TEXT
  CHECK (timing_verdict IN ('good', 'usable', 'not_for_timing'));
ALTER TABLE session ADD COLUMN timing_gate TEXT;
ALTER TABLE session ADD COLUMN timing_calibration TEXT;
ALTER TABLE session ADD COLUMN keyboard_description TEXT NOT NULL DEFAULT '';
ALTER TABLE session ADD COLUMN visual_line TEXT
  CHECK (visual_line IN ('first', 'mouth', 'calibrated'));
ALTER TABLE session ADD COLUMN visual_line_ns INTEGER;
ALTER TABLE session ADD COLUMN sound_levels TEXT;
ALTER TABLE plan ADD COLUMN repeats INTEGER;
ALTER TABLE trial ADD COLUMN excluded INTEGER NOT NULL DEFAULT 0 CHECK (excluded IN (0, 1));
ALTER TABLE trial ADD COLUMN rt_reference TEXT;
ALTER TABLE trial ADD COLUMN rt_reference_ns INTEGER;
ALTER TABLE trial ADD COLUMN rt_uncertainty_ns INTEGER;
ALTER TABLE keystroke ADD COLUMN uncertainty_ns INTEGER;
ALTER TABLE keystroke ADD COLUMN x REAL;
ALTER TABLE keystroke ADD COLUMN y REAL;

CREATE TABLE clock_map (
  session        INTEGER NOT NULL,
  trial          INTEGER NOT NULL,
  clock          TEXT NOT NULL CHECK (clock IN ('display', 'sound')),
  source         TEXT NOT NULL,
  at_ns          INTEGER NOT NULL,
  device_at      INTEGER NOT NULL,
  ns_per_unit    REAL NOT NULL,
  drift_ppm      REAL,
  residual_ns    INTEGER NOT NULL,
  readings       INTEGER NOT NULL,
  rejected       INTEGER NOT NULL,
  jumps          INTEGER NOT NULL,
  PRIMARY KEY (session, trial, clock),
  FOREIGN KEY (session, trial) REFERENCES trial (session, trial)
) STRICT, WITHOUT ROWID;

CREATE TABLE trigger (
  session        INTEGER NOT NULL,
  trial          INTEGER NOT NULL,
  ordinal        INTEGER NOT NULL,
  kind           TEXT NOT NULL CHECK (kind IN ('photodiode', 'click', 'serial', 'socket')),
  event          TEXT NOT NULL,
  code           INTEGER,
  planned_ns     INTEGER NOT NULL,
  sent_ns        INTEGER,
  uncertainty_ns INTEGER,
  source         TEXT NOT NULL,
  PRIMARY KEY (session, trial, ordinal),
  FOREIGN KEY (session, trial) REFERENCES trial (session, trial)
) STRICT, WITHOUT ROWID;

DROP VIEW answers;
CREATE VIEW answers AS
  SELECT s.participant, s.session, p.trial, p.phase, p.block, p.condition, p.auditory_talker,
         p.visual_talker, p.snr_db, p.word, p.phones, t.response, t.timed_out, t.flagged,
         (t.submitted_ns - coalesce(t.rt_reference_ns, t.stimulus_end_ns)) / 1e6 AS rt_ms,
         s.simulated_answers, s.simulated_time, p.visual_word, p.articulation, p.face,
         t.excluded, p.repeats, t.rt_reference, t.rt_uncertainty_ns / 1e6 AS rt_uncertainty_ms,
         s.timing_verdict
  FROM trial t JOIN plan p USING (session, trial) JOIN session s USING (session);
)sql";

/// What makes each version of the one before it, from version 1 on.
inline constexpr std::array<const char*, kSchemaVersion> kSchemaSteps{
    kVersion1, kVersion2, kVersion3, kVersion4, kVersion5, kVersion6};

}  // namespace bimodal::runner

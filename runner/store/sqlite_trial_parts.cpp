#include "runner/store/sqlite_trial_parts.hpp"

#include <string>
#include <utility>

namespace bimodal::runner {

namespace {

void read_onsets(Database& database, const TrialsById& trials) {
  Statement row{database,
                "SELECT session, trial, modality, planned_ns, reported_ns, source FROM onset"};
  while (row.step()) {
    trials.at({row.integer(0), row.integer(1)})
        ->onsets.push_back({row.text(2), row.duration(3), row.optional_duration(4), row.text(5)});
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
                    .noise_dbfs = row.optional_real(6),
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
                                .uncertainty = row.optional_duration(5),
                                .x = row.optional_real(6),
                                .y = row.optional_real(7)});
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
                                .drift_ppm = row.optional_real(7),
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
                          .sent = row.optional_duration(6),
                          .uncertainty = row.optional_duration(7),
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

void read_trial_parts(Database& database, std::int64_t version, const TrialsById& trials) {
  const bool has_recordings = version >= 2;
  const bool has_timing = version >= 6;
  read_onsets(database, trials);
  read_sounds(database, trials);
  if (has_recordings) read_recordings(database, trials);
  read_keystrokes(database, trials, has_timing);
  if (has_timing) read_clock_maps(database, trials);
  if (has_timing) read_triggers(database, trials);
  read_events(database, trials);
}

}  // namespace bimodal::runner

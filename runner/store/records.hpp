#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// How a device introduced itself, and what it can vouch for.
struct DeviceRecord {
  std::string kind;         ///< "sdl", "headless", "portaudio", "none", "simulated"
  std::string description;  ///< driver, renderer, host API, latency, as text for people
  std::string time_source;  ///< what its instants rest on: "swap_returned", "predicted", ...
};

/// How the synthetic face was drawn, alike in all trials.
struct FaceDrawingRecord {
  std::string quality;  ///< "fast", "full"
  std::string basis;    ///< why: "protocol", "measured", "unwatched"
  /// What a picture took in full quality before the session; absent: not measured.
  std::optional<Duration> full_picture;
  std::string renderer;  ///< the OpenGL that drew it
};

/// What the session's timing rests on.
struct TimingRecord {
  std::string verdict;      ///< of the gate at start-up: "good", "usable", "not_for_timing"
  std::string gate;         ///< what it found, as JSON
  std::string calibration;  ///< by instruments, as JSON; empty: none
  /// To which line of the screen visual onsets refer: "first", "mouth", "calibrated".
  std::string visual_line;
  Duration visual_line_after{};  ///< of that line after the first one
};

/// One run of one protocol with one participant.
struct SessionRecord {
  std::int64_t id = 0;  ///< given by the store
  std::string participant;
  int participant_number = 1;
  int session_number = 1;
  std::string protocol_title;
  std::string protocol_text;    ///< the file as read, byte for byte
  std::string protocol_sha256;  ///< of protocol_text
  /// What was chosen when the protocol was run, as JSON: conditions left out and taken in, and the
  /// folder and digest of each corpus. Empty: as the protocol is written, without corpora.
  std::string cast;
  std::uint64_t seed = 0;
  std::string program_version;
  bool simulated_answers = false;  ///< a simulated observer answered
  bool simulated_time = false;     ///< devices ran on virtual time
  std::string observer;            ///< the simulated observer's name; empty for people
  std::string started_utc;         ///< ISO 8601
  DeviceRecord display;
  DeviceRecord audio;
  Duration refresh_period{};     ///< measured; 0 if there is no display
  Duration refresh_deviation{};  ///< standard deviation of the measured periods
  int refresh_count = 0;         ///< number of periods measured
  /// Absent: no synthetic face was drawn (also in rehearsals), or files of versions below 4.
  std::optional<FaceDrawingRecord> face;
  std::optional<TimingRecord> timing;  ///< absent: rehearsals, and files of versions below 6
  std::string keyboard_description;    ///< what answers came from, and how their instants are found
  /// What is known of sound pressure on the output, as JSON; empty: nothing, or an older file.
  std::string sound_levels;
};

/// One trial as planned; all of a session's plan is stored before its first trial.
struct PlanRecord {
  int trial = 0;      ///< from 0
  std::string phase;  ///< "practice" or "main"
  int block = 0;
  std::string word;
  std::string phones;                       ///< "S T UW"
  std::optional<std::string> visual_word;   ///< what was seen, if it was another word
  std::optional<std::string> articulation;  ///< what the face did where sounds are ambiguous
  /// What the synthetic face looked like, as JSON; absent: none, or files of versions below 5.
  std::optional<std::string> face;
  std::string condition;
  std::optional<std::string> auditory_talker;
  std::optional<std::string> visual_talker;
  std::optional<double> snr_db;
  std::uint64_t noise_seed = 0;
  std::optional<int> repeats;  ///< the trial whose timing was not as planned and that this repeats
};

/// One onset, planned and reported on the session clock.
struct OnsetRecord {
  std::string modality;  ///< "auditory" or "visual"
  Duration planned{};    ///< since session clock zero
  std::optional<Duration> reported;
  std::string source;  ///< "predicted", "swap_returned", "driver_reported", "stream_time"
};

/// The sound of a trial, as it was handed to the device.
struct SoundRecord {
  std::string sha256;  ///< of the samples, 32-bit little-endian floats
  int rate_hz = 0;
  std::int64_t samples = 0;
  double speech_dbfs = 0.0;          ///< level in the band over the speech interval
  std::optional<double> noise_dbfs;  ///< level in the band
  double band_low_hz = 0.0;
  double band_high_hz = 0.0;
  double peak = 0.0;        ///< largest absolute sample
  Duration speech_start{};  ///< within the sound
  Duration speech_end{};
};

/// A recording of a natural talker that was heard or seen.
struct RecordingRecord {
  std::string modality;  ///< "auditory" or "visual"
  std::string talker;    ///< "corpus:NAME"
  std::string item;      ///< of the corpus
  std::string file;      ///< within the corpus's folder
  std::string sha256;    ///< of that file
  Duration start{};      ///< of the item within the file, margins included
  Duration end{};
};

/// Which prepared frame each refresh of the stimulus showed, and when. Parallel arrays.
struct RefreshRecord {
  std::vector<std::int64_t> frame;  ///< index of the prepared frame
  /// The frame of the video file that it is; -1: blank. Empty unless natural video was shown.
  std::vector<std::int64_t> source_frame;
  std::vector<Duration> planned;  ///< session clock
  std::vector<Duration> shown;    ///< session clock, by the display's time source
};

/// How a device's clock lay on the session clock in a trial: device instant `device_at` was session
/// instant `at`, and each unit later is so much later.
struct ClockMapRecord {
  std::string clock;                ///< "display" (unit: a refresh), "sound" (unit: a sample)
  std::string source;               ///< what its readings rest on, as in OnsetRecord
  Duration at{};                    ///< session clock
  std::int64_t device_at = 0;       ///< refresh or sample of the stream, counted from its start
  double nanoseconds_per_unit = 0;  ///< on the session clock
  std::optional<double> drift_ppm;  ///< against the nominal rate; absent: it has none
  Duration residual{};              ///< standard deviation of the readings about the line
  std::int64_t readings = 0;
  std::int64_t rejected = 0;  ///< of them, outliers
  int jumps = 0;              ///< since the session began
};

/// A signal for other equipment.
struct TriggerRecord {
  std::string kind;         ///< "photodiode", "click", "serial", "socket"
  std::string event;        ///< what it stands for: "visual_zero", "auditory_zero", ...
  std::optional<int> code;  ///< the byte sent; absent: it carries none
  Duration planned{};
  std::optional<Duration> sent;         ///< absent: it was not
  std::optional<Duration> uncertainty;  ///< it left at most so long before `sent`
  std::string source;                   ///< of that instant
};

struct KeystrokeRecord {
  Duration at{};
  std::string source;  ///< "poll" (noticed when polled), "evdev", "compositor", ..., "simulated"
  std::string key;     ///< the text typed, or "Backspace", "Enter"
  std::optional<Duration> uncertainty{};  ///< it happened at most so long before `at`
  std::optional<double> x{};              ///< of a pointer, as parts of the window
  std::optional<double> y{};
};

struct ResponseRecord {
  std::string text;                   ///< as submitted, UTF-8; empty for an omission
  Duration submitted{};               ///< session clock
  std::optional<Duration> first_key;  ///< session clock
  bool timed_out = false;
  /// From where reaction time counts: "sound_onset", "visual_onset", "end"; empty: files of
  /// versions below 6 (from the planned end).
  std::string reference;
  std::optional<Duration> reference_at;  ///< session clock
  std::optional<Duration> uncertainty;   ///< of `submitted`: it happened at most so long before
};

struct EventRecord {
  Duration at{};
  std::string kind;  ///< "late_frame", "underflow", "device_lost", "break", "abort", ...
  std::string detail;
};

/// Everything about one trial that took place; stored in one transaction.
struct TrialRecord {
  int trial = 0;
  Duration stimulus_start{};  ///< session clock: first refresh of the stimulus, planned
  Duration stimulus_end{};    ///< session clock: planned
  std::vector<OnsetRecord> onsets;
  std::optional<SoundRecord> sound;
  std::vector<RecordingRecord> recordings;
  RefreshRecord refreshes;
  ResponseRecord response;
  std::vector<KeystrokeRecord> keystrokes;
  std::vector<EventRecord> events;
  std::vector<ClockMapRecord> clock_maps;
  std::vector<TriggerRecord> triggers;
  bool flagged = false;   ///< timing was not as planned (late frames, underflow)
  bool excluded = false;  ///< and by the protocol's rule it is not to be analysed
};

}  // namespace bimodal::runner

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocols/model/face.hpp"
#include "protocols/model/response.hpp"
#include "protocols/model/timing.hpp"
#include "protocols/model/triggers.hpp"
#include "stimuli/base/quantity.hpp"
#include "stimuli/base/random.hpp"
#include "stimuli/timeline/account.hpp"

namespace bimodal::protocols {

/// What is seen after the gate.
enum class AfterGate {
  Blank,   ///< the background, and silence
  Freeze,  ///< the last picture, and silence
};

/// Where a stimulus is cut off: at an instant since the onset of the speech, or at the end of a
/// phone.
struct Gate {
  std::optional<Duration> at;  ///< on the stimulus's own time, after a change of rate
  int after_phone = 0;         ///< from 1; meant if `at` is absent
  AfterGate picture = AfterGate::Blank;

  bool operator==(const Gate&) const = default;
};

/// How a recording or a voice is presented.
struct Manner {
  double rate =
      1.0;  ///< times as fast, without change of pitch; natural video keeps its frame rate
  bool reversed = false;
  std::optional<Gate> gate;

  bool operator==(const Manner&) const = default;
};

/// How a visual talker's picture is shown, so that two talkers can be made comparable.
struct Look {
  std::string like;                 ///< "corpus:NAME" or "face": whose look to match; or empty
  std::optional<Hertz> frame_rate;  ///< the picture changes no more often than this
  std::optional<int> lines;         ///< drawn with so many lines, then enlarged to its height
  std::optional<int> height;        ///< pixels on the screen; absent: Window::face_height
  double blur_px = 0.0;             ///< standard deviation of a Gaussian, pixels on the screen
  std::optional<std::uint32_t> background;  ///< behind the synthetic face, 0xRRGGBB

  bool operator==(const Look&) const = default;
};

/// How the synthetic face articulates.
struct Articulating {
  Account account = Account::Dominance;
  /// The inventory of segments: as written, the name of one that ships or a path relative to the
  /// protocol; from read_protocol, its file.
  std::string segments = "english";

  bool operator==(const Articulating&) const = default;
};

/// What is heard and seen in one kind of trial. At least one of the talkers is given.
struct Condition {
  std::string name;
  bool optional = false;  ///< in the experiment only if it is asked for
  /// "festival:kal", "festival:slt", "corpus:NAME"; absent: silence
  std::optional<std::string> auditory_talker;
  std::optional<std::string> visual_talker;  ///< "face", "corpus:NAME"; absent: no picture
  /// The voice or recording that times the face where nothing is heard; where something is, it is
  /// that one.
  std::string timing_talker = "festival:kal";
  std::optional<Decibels> snr;        ///< absent: no noise
  std::optional<Duration> av_offset;  ///< absent: Intervals::av_offset
  Manner manner;
  Look look;
  Articulating articulating;
  Face face;  ///< of the synthetic face: its own keys, else those of Protocol::face
};

/// How words meet conditions.
enum class Assignment {
  Once,            ///< each word in one condition per participant, lists counterbalanced over them
  EveryCondition,  ///< each word in every condition, over as many sessions as there are conditions
};

struct Noise {
  Hertz band_low{80};     ///< speech and noise levels are measured between these,
  Hertz band_high{8000};  ///< and the noise is limited to them
  Duration lead = std::chrono::milliseconds{500};   ///< noise before the recording begins
  Duration trail = std::chrono::milliseconds{500};  ///< and after it ends
  Duration ramp = std::chrono::milliseconds{50};    ///< raised cosine at both ends
};

/// Channels of the sound output are counted from 1 to this.
inline constexpr int kMostChannels = 32;

struct Sound {
  Hertz rate{48'000};
  std::vector<int> channels;     ///< that the stimulus is heard on; none: both ears, 1 and 2
  Decibels speech_level{-30.0};  ///< RMS of the speech interval, dB re full scale; constant
  /// What it is to be at the ear; then speech_level follows from the output's calibration.
  std::optional<DecibelsSpl> speech_spl;
  Noise noise;
};

struct Practice {
  std::string list;  ///< as written: a list of the library or a file; empty: spelled out here
  std::vector<std::string>
      words;  ///< spellings outside the main list; one trial each, conditions in turn
};

struct Breaks {
  int every_trials = 0;  ///< 0: none
  std::string text;
};

struct Intervals {
  Duration fixation = std::chrono::milliseconds{500};  ///< fixation mark before the stimulus
  Duration lead = std::chrono::milliseconds{500};      ///< still face before the recording begins
  Duration trail = std::chrono::milliseconds{500};     ///< still face after it ends
  Duration pause = std::chrono::milliseconds{500};     ///< blank between trials
  Duration av_offset{};                                ///< audio minus visual: positive, audio lags
};

/// How finely the synthetic face is drawn: alike in the whole session, so that conditions never
/// differ by it.
enum class FaceQuality {
  Auto,  ///< as the machine can: measured when a session begins
  Fast,  ///< light that the face keeps from itself is worked out at rest
  Full,  ///< shadows follow every movement, smooth edges; slow without a graphics card
};

struct Window {
  int width = 1280;  ///< pixels
  int height = 1024;
  bool fullscreen = true;
  int face_height = 720;                ///< pixels; the face's picture is 8/9 as wide as it is high
  std::uint32_t background = 0x606060;  ///< 0xRRGGBB
  FaceQuality face_quality = FaceQuality::Auto;
};

/// A whole experiment, as its author wrote it and the reader judged it.
struct Protocol {
  std::string title;
  std::string description;
  Seed seed = 0;
  std::vector<std::string> instructions;  ///< pages
  std::string words;  ///< as written: a list of the library or a file; empty: spelled out here
  std::vector<Condition> conditions;
  Assignment assignment = Assignment::Once;
  Practice practice;
  Breaks breaks;
  Response response;
  Intervals intervals;
  Sound sound;
  Window window;
  Timing timing;
  Triggers triggers;
  Face face;  ///< the synthetic face, where conditions do not say otherwise
  std::string farewell;
};

}  // namespace bimodal::protocols

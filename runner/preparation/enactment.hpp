#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "protocols/model/protocol.hpp"
#include "runner/preparation/repertoire.hpp"
#include "stimuli/timeline/segment.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal::runner {

/// What is heard and seen in a trial, before noise is added and pictures are drawn: one or two
/// performances on one time, in the manner of the condition.
struct Enactment {
  Duration length{};
  /// What is heard: as long as the enactment. Null: nothing. What the gate silences still sounds
  /// here.
  std::shared_ptr<const Clip> sound;
  Utterance heard;  ///< its phones; empty if nothing is heard
  Utterance seen;   ///< what is said by the picture
  /// What the synthetic face does, ambiguous where the word is; empty for a natural picture.
  std::vector<TimedSegment> articulation;
  std::optional<RecordedSource> sound_source;    ///< of a natural voice
  std::optional<RecordedSource> picture_source;  ///< of natural video
  /// Where the start of the picture's recording stands, before rate and reversal.
  Duration picture_start{};
  double rate = 1.0;
  bool reversed = false;
  std::optional<Duration> gate;  ///< nothing is heard, and seen only as the gate says, from here on
  /// The releases that were brought together; absent unless two performances were.
  std::optional<Duration> release;
};

/// Puts together what a condition and a word ask for. Two different performances (a voice and the
/// video of another talker, or the same talker's of another word) are aligned at the release of
/// their first consonants (release_of); where one is longer than the other, the sound is silent and
/// the picture rests. An ambiguous word that nobody is heard to say has the times between its two
/// ends (see between()). The rate changes after that, then the direction, then the gate falls.
/// Throws Error, naming the word, if a talker cannot say it, a recording that is to be heard has no
/// sound, or the gate lies behind the end.
[[nodiscard]] Enactment enact(const protocols::Condition& condition,
                              const Word& word,
                              Repertoire& repertoire);

/// The instant of a picture's recording that stands at `time` of the enactment, from the zero of
/// the recording's file.
[[nodiscard]] Duration recording_time(const Enactment& enactment, Duration time);

}  // namespace bimodal::runner

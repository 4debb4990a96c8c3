#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "protocols/design/plan.hpp"
#include "runner/devices/audio_output.hpp"
#include "runner/preparation/enactment.hpp"
#include "runner/preparation/film_studio.hpp"
#include "runner/preparation/frame_source.hpp"
#include "runner/preparation/repertoire.hpp"
#include "runner/session/cue_sheet.hpp"
#include "runner/store/records.hpp"
#include "stimuli/audio/mix.hpp"

namespace bimodal::runner {

/// One trial with everything decoded, mixed, drawn and checked.
struct PreparedTrial {
  protocols::PlannedTrial plan;
  StimulusLayout layout;
  std::optional<Sound> sound;
  std::optional<SoundRecord> sound_record;
  Hertz drawing_rate{60};    ///< at which the frames follow each other
  std::int64_t frames = 0;   ///< of the picture; 0 if nobody is seen
  std::optional<Film> film;  ///< absent also where pictures are not drawn (rehearsal)
  std::vector<RecordingRecord> recordings;  ///< that are heard and seen
  /// The reported audio-visual offset may differ so much from layout.av_offset before the trial is
  /// flagged.
  Duration offset_tolerance = std::chrono::milliseconds{4};
};

/// Turns planned trials into prepared ones. Belongs to one thread.
class TrialPreparer {
 public:
  /// All are borrowed. Without `studio` no pictures are drawn.
  TrialPreparer(const protocols::Protocol& protocol,
                Repertoire& repertoire,
                FilmStudio* studio,
                Hertz drawing_rate);

  /// Throws Error, naming trial and word, if the sound would clip or cannot be made.
  [[nodiscard]] PreparedTrial prepare(
      const protocols::PlannedTrial& trial, const Checkpoint& checkpoint = [] {});

  /// The bytes that the trial's film takes in the studio's cache, where it counts as used now; 0 if
  /// nothing is drawn in the trial; absent if its film is still to be drawn.
  [[nodiscard]] std::optional<std::uintmax_t> kept_film_bytes(const protocols::PlannedTrial& trial);

  /// The sound alone; absent if the condition has none. Does not judge clipping. Throws Error as
  /// enact() does, also where nothing is heard.
  [[nodiscard]] std::optional<Mix> mix_sound(const protocols::PlannedTrial& trial);

 private:
  /// Enacted once and kept.
  struct Kept {
    Enactment enactment;
    std::optional<Decibels> level;  ///< of the recording, once measured
  };

  [[nodiscard]] Kept& kept(const protocols::PlannedTrial& trial);
  [[nodiscard]] StimulusLayout layout_of(const protocols::Condition& condition,
                                         const Enactment& enactment) const;

  const protocols::Protocol& protocol_;
  Repertoire& repertoire_;
  FilmStudio* studio_;
  Hertz drawing_rate_;
  FourierTransform fourier_;
  std::unordered_map<std::string, Kept> kept_;
};

/// What must be said if a trial's sound would clip; empty if it would not.
[[nodiscard]] std::string clipping_message(const protocols::PlannedTrial& trial,
                                           const std::string& condition,
                                           const Mix& mix);

}  // namespace bimodal::runner

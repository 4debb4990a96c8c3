#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "stimuli/audio/clip.hpp"
#include "stimuli/corpus/corpus.hpp"
#include "stimuli/timeline/utterance.hpp"
#include "stimuli/video/kept_tracks.hpp"
#include "stimuli/words/word_list.hpp"
#include "synth/voice/voice.hpp"

namespace bimodal::runner {

/// Where a natural performance comes from.
struct RecordedSource {
  std::string corpus;  ///< its name in the protocol
  std::string item;
  std::string file;    ///< of the recording, relative to the corpus's folder
  std::string sha256;  ///< of that file, as the manifest has it
  std::filesystem::path path;
  MediaSpan span;  ///< of the item, margins included
};

/// A talker saying one item, as it was spoken.
struct Performance {
  Clip sound;                            ///< at the session's rate; empty if the recording has none
  Utterance utterance;                   ///< ends where the recording ends
  std::optional<RecordedSource> source;  ///< of a natural talker
  /// The release of the first consonant; absent: to be measured in the sound (release_of).
  std::optional<Duration> release;

  [[nodiscard]] Duration length() const { return utterance.end(); }
};

/// What the talkers of a protocol can say: each item spoken or read once and kept. May be used by
/// several threads.
class Repertoire {
 public:
  /// `corpora`: by name; borrowed.
  Repertoire(Hertz rate, const std::map<std::string, Corpus>& corpora)
      : rate_{rate}, corpora_{corpora} {}

  /// A word as `talker` ("festival:kal", "corpus:NAME") says it; a corpus says it as it was
  /// recorded, whatever `phones`; where its neighbours stand in its margins they are silenced. The
  /// reference stays valid as long as the repertoire. Throws Error for a talker or word that cannot
  /// be had.
  [[nodiscard]] const Performance& perform(const std::string& talker,
                                           const std::string& spelling,
                                           const Pronunciation& phones);

  /// A word as it times a face. An ambiguous one of a voice has no sound: its times, and its
  /// release, lie between those of its two ends (see between()). A corpus says it as it was
  /// recorded. As above.
  [[nodiscard]] const Performance& perform(const std::string& talker, const SeenWord& word);

  [[nodiscard]] Hertz rate() const { return rate_; }

  [[nodiscard]] const std::map<std::string, Corpus>& corpora() const { return corpora_; }

 private:
  [[nodiscard]] Performance speak(const std::string& talker,
                                  const std::string& spelling,
                                  const Pronunciation& phones);
  [[nodiscard]] Performance lie_between(const std::string& talker, const SeenWord& word);
  [[nodiscard]] Performance play(const std::string& name, const std::string& spelling);

  Hertz rate_;
  const std::map<std::string, Corpus>& corpora_;
  std::mutex mutex_;
  std::map<std::string, synth::Voice> voices_;
  KeptTracks tracks_;
  std::map<std::string, std::unique_ptr<Performance>> performances_;
};

}  // namespace bimodal::runner

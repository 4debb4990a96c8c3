#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "stimuli/audio/clip.hpp"
#include "stimuli/timeline/phone.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

/// One word to be found in a recording: its pronunciations, of which the likeliest is taken.
struct SpokenWord {
  std::string spelling;
  std::vector<Pronunciation> pronunciations;  ///< at least one, none empty
};

/// Where one word of an alignment stands.
struct AlignedWord {
  std::string spelling;
  std::size_t first_phone = 0;  ///< index into Alignment::utterance.phones
  std::size_t phones = 0;       ///< their number
};

/// A recording and when each phone sounds in it.
struct Alignment {
  Utterance utterance;  ///< begins and ends with rest; ends where the sound ends
  std::vector<AlignedWord> words;
  /// How well the sound fits: mean over the words of the acoustic log likelihood (natural
  /// logarithm, per frame of 10 ms) of the aligned phones less that of the best free sequence of
  /// phones in the same frames. 0 at best; the lower, the likelier that something else was said.
  double fit = 0.0;
  std::vector<double> fit_of_word;  ///< the same for each word by itself
};

/// A word whose fit is lower is doubtful: it may not be what was said.
inline constexpr double kDoubtfulFit = -3.0;

/// Finds known words in a clean recording, with the acoustic model of PocketSphinx: first with
/// phones as they are in no particular context, which decides on pronunciations and pauses, then
/// with triphones; rest is only before, after and between words. The edge between two frames of 10
/// ms is put midway between their centres, and some edges are then moved (see correct_edges).
///
/// Align before mixing noise: at 0 dB S/N boundaries are off by 40 ms.
/// One aligner may be used by one thread at a time; aligners share nothing.
class Aligner {
 public:
  /// Throws Error naming the Debian package if the acoustic model is not there ($BIMODAL_ACOUSTICS
  /// or where pocketsphinx-en-us puts it).
  Aligner();
  ~Aligner();
  Aligner(Aligner&&) noexcept;
  Aligner& operator=(Aligner&&) noexcept;
  Aligner(const Aligner&) = delete;
  Aligner& operator=(const Aligner&) = delete;

  /// One word. Every phone is returned, in order, each at least 30 ms long. Sound of any rate; a
  /// recording cut flush to the word is padded for the search, and the rest at its ends may then be
  /// empty in time. Throws Error, saying what was asked for, if the sound is too short for the
  /// phones, silent, longer than ten minutes, or holds what is no number.
  [[nodiscard]] Alignment align(const Clip& sound, std::span<const Phone> phones);

  /// Several words in order, with or without pauses between.
  [[nodiscard]] Alignment align(const Clip& sound, std::span<const SpokenWord> words);

 private:
  struct Decoder;
  std::unique_ptr<Decoder> decoder_;
};

}  // namespace bimodal

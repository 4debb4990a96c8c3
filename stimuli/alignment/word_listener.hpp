#pragma once

#include <memory>
#include <optional>
#include <span>

#include "stimuli/alignment/aligner.hpp"
#include "stimuli/audio/clip.hpp"

namespace bimodal {

/// A stretch of sound that has been listened to once and can then be compared with many words, each
/// at the cost of a few microseconds. Must not outlive its WordListener.
class HeardStretch {
 public:
  HeardStretch(HeardStretch&&) noexcept;
  HeardStretch& operator=(HeardStretch&&) noexcept;
  HeardStretch(const HeardStretch&) = delete;
  HeardStretch& operator=(const HeardStretch&) = delete;
  ~HeardStretch();

  /// How well the whole stretch is these words in order, with rest before, after and between: log
  /// likelihood (natural logarithm) of the best alignment less that of the best sequence of any
  /// phones and rests, per frame of 10 ms of what is not the silence around. 0 at best. Unlike
  /// Alignment::fit it counts what is left over too: "ape" does not fit the sound of "apron".
  /// Absent if the stretch is too short for the phones.
  [[nodiscard]] std::optional<double> fit(std::span<const SpokenWord> words) const;
  [[nodiscard]] std::optional<double> fit(const SpokenWord& word) const;

 private:
  friend class WordListener;
  struct Scores;
  explicit HeardStretch(std::unique_ptr<Scores> scores);
  std::unique_ptr<Scores> scores_;
};

/// Listens to stretches of a recording, in order to find out which of many words each is; the
/// acoustic model and its units are those of Aligner. listen() may be used by one thread at a time,
/// HeardStretch::fit by any number.
class WordListener {
 public:
  /// Throws Error as Aligner does.
  WordListener();
  ~WordListener();
  WordListener(WordListener&&) noexcept;
  WordListener& operator=(WordListener&&) noexcept;
  WordListener(const WordListener&) = delete;
  WordListener& operator=(const WordListener&) = delete;

  /// `speech` is how much of the sound is not silence. Throws Error if the sound is empty or
  /// silent.
  [[nodiscard]] HeardStretch listen(const Clip& sound, Duration speech);

 private:
  struct Ear;
  std::unique_ptr<Ear> ear_;
};

}  // namespace bimodal

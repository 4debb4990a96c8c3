#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace bimodal {

/// How well each chunk of a recording is each word of a list: a log likelihood ratio per frame to
/// the word that the chunk fits best, so 0 at best (for a word that is really said mostly above
/// -1.5, for another one about -4). What has not been compared is kNotCompared.
class ChunkWordFits {
 public:
  static constexpr float kNotCompared = -std::numeric_limits<float>::infinity();

  ChunkWordFits(std::size_t chunks, std::size_t words)
      : chunks_{chunks}, words_{words}, one_(chunks * words, kNotCompared), two_(one_) {}

  [[nodiscard]] std::size_t chunks() const { return chunks_; }

  [[nodiscard]] std::size_t words() const { return words_; }

  /// The chunk is this word.
  [[nodiscard]] float& one(std::size_t chunk, std::size_t word) {
    return one_[chunk * words_ + word];
  }

  [[nodiscard]] float one(std::size_t chunk, std::size_t word) const {
    return one_[chunk * words_ + word];
  }

  /// The chunk is this word and the next one, read without a pause.
  [[nodiscard]] float& two(std::size_t chunk, std::size_t word) {
    return two_[chunk * words_ + word];
  }

  [[nodiscard]] float two(std::size_t chunk, std::size_t word) const {
    return two_[chunk * words_ + word];
  }

 private:
  std::size_t chunks_;
  std::size_t words_;
  std::vector<float> one_;
  std::vector<float> two_;
};

/// What matching costs, in the unit of the fits.
struct MatchCosts {
  float match = 1.5F;          ///< gained with every word found; its fit is added
  float worst = -3.0F;         ///< a match of any fit is not worth less than this
  float skipped_chunk = 0.3F;  ///< a cough, a comment
  float skipped_word = 0.3F;   ///< not read
  float again = 1.0F;          ///< the word before is said once more; a cough is likelier
};

/// A chunk and the word that it is.
struct Match {
  std::size_t chunk = 0;
  std::size_t word = 0;
  bool with_next = false;  ///< the chunk holds the next word too

  bool operator==(const Match&) const = default;
};

/// Which chunk is which word of a list that was read in order: the dearest of all ways to go
/// through both (dynamic programming), where chunks may be none of the words, words may be left
/// out, a word may be said several times in succession, with or without other chunks between, and
/// a chunk may hold two words. In order of the chunks; a chunk comes at most once, a word as often
/// as it is said.
[[nodiscard]] std::vector<Match> match_list(const ChunkWordFits& fits,
                                            const MatchCosts& costs = {});

}  // namespace bimodal

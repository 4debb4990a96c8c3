#include "stimuli/corpus/match_list.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

namespace bimodal {

namespace {

/// How a place (chunks and words used up) was reached.
enum class Step : std::uint8_t { None, SkipChunk, SkipWord, One, Two, Again };

struct Place {
  float value = ChunkWordFits::kNotCompared;
  Step step = Step::None;

  void offer(float offered, Step by) {
    if (offered > value) *this = {offered, by};
  }
};

float worth(float fit, const MatchCosts& costs) {
  if (fit == ChunkWordFits::kNotCompared) return fit;
  return std::max(costs.worst, costs.match + fit);
}

/// The best way to a chunk and word: from the row before (of the chunk before) and the places on
/// its left in its own row.
Place best_place(const ChunkWordFits& fits,
                 const MatchCosts& costs,
                 std::span<const float> before,
                 std::span<const Place> row,
                 std::size_t chunk,
                 std::size_t word) {
  Place place;
  if (chunk == 0 && word == 0) place.value = 0.0F;
  if (word > 0) place.offer(row[word - 1].value - costs.skipped_word, Step::SkipWord);
  if (chunk == 0) return place;
  place.offer(before[word] - costs.skipped_chunk, Step::SkipChunk);
  if (word > 0) {
    const float alone = worth(fits.one(chunk - 1, word - 1), costs);
    place.offer(before[word - 1] + alone, Step::One);
    place.offer(before[word] + alone - costs.again, Step::Again);
  }
  if (word > 1) {
    const float both = worth(fits.two(chunk - 1, word - 2), costs);
    place.offer(before[word - 2] + 2.0F * both, Step::Two);
  }
  return place;
}

}  // namespace

std::vector<Match> match_list(const ChunkWordFits& fits, const MatchCosts& costs) {
  const auto words = fits.words();
  const auto width = words + 1;
  std::vector<float> before(width);
  std::vector<Place> row(width);
  std::vector<Step> steps((fits.chunks() + 1) * width, Step::None);
  for (std::size_t chunk = 0; chunk <= fits.chunks(); ++chunk) {
    for (std::size_t word = 0; word <= words; ++word) {
      row[word] = best_place(fits, costs, before, row, chunk, word);
      steps[chunk * width + word] = row[word].step;
    }
    std::ranges::transform(row, before.begin(), &Place::value);
  }

  std::vector<Match> found;
  std::size_t chunk = fits.chunks();
  std::size_t word = words;
  while (chunk > 0 || word > 0) {
    const auto step = steps[chunk * width + word];
    if (step == Step::One || step == Step::Again) found.push_back({chunk - 1, word - 1, false});
    if (step == Step::Two) found.push_back({chunk - 1, word - 2, true});
    if (step != Step::SkipWord) --chunk;
    if (step == Step::SkipWord || step == Step::One) --word;
    if (step == Step::Two) word -= 2;
  }
  std::ranges::reverse(found);
  return found;
}

}  // namespace bimodal

#include "stimuli/corpus/match_list.hpp"

#include <algorithm>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Fits as they are measured: right ones near 0, wrong ones about -4. `said[i]` is the word of
/// chunk i; absent: a cough, which fits anything badly but something best.
ChunkWordFits fits_of(const std::vector<std::optional<std::size_t>>& said,
                      std::size_t words,
                      Random& random) {
  ChunkWordFits fits{said.size(), words};
  for (std::size_t chunk = 0; chunk < said.size(); ++chunk) {
    for (std::size_t word = 0; word < words; ++word) {
      fits.one(chunk, word) = static_cast<float>(-3.0 - 3.0 * random.uniform());
    }
    if (said[chunk]) fits.one(chunk, *said[chunk]) = static_cast<float>(-random.uniform());
  }
  return fits;
}

TEST(MatchList, FindsEveryWordWhereAllAreReadOnce) {
  Random random{1};
  const auto fits = fits_of({0, 1, 2}, 3, random);
  EXPECT_THAT(match_list(fits), ElementsAre(Match{0, 0}, Match{1, 1}, Match{2, 2}));
}

TEST(MatchList, LeavesOutCoughsAndMissingWords) {
  Random random{2};
  const auto fits = fits_of({0, std::nullopt, 1, 3, std::nullopt}, 4, random);
  EXPECT_THAT(match_list(fits), ElementsAre(Match{0, 0}, Match{2, 1}, Match{3, 3}));
}

TEST(MatchList, FindsEveryTakeOfAWordWithACommentBetween) {
  Random random{3};
  const auto fits = fits_of({0, 1, std::nullopt, 1, 1, 2}, 3, random);
  EXPECT_THAT(match_list(fits),
              ElementsAre(Match{0, 0}, Match{1, 1}, Match{3, 1}, Match{4, 1}, Match{5, 2}));
}

TEST(MatchList, SplitsAChunkThatHoldsTwoWords) {
  Random random{4};
  auto fits = fits_of({0, std::nullopt, 3}, 4, random);
  fits.two(1, 1) = -0.2F;
  EXPECT_THAT(match_list(fits), ElementsAre(Match{0, 0}, Match{1, 1, true}, Match{2, 3}));
}

TEST(MatchList, DoesNotTakeAnotherWordForAMissingOne) {
  Random random{5};
  const auto fits = fits_of({0, std::nullopt, 2}, 3, random);
  EXPECT_THAT(match_list(fits), ElementsAre(Match{0, 0}, Match{2, 2}));
}

TEST(MatchList, TakesAnUncertainWordInItsPlace) {
  Random random{6};
  auto fits = fits_of({0, 1, 2}, 3, random);
  fits.one(1, 1) = -1.8F;
  EXPECT_THAT(match_list(fits), ElementsAre(Match{0, 0}, Match{1, 1}, Match{2, 2}));
}

TEST(MatchList, IsEmptyWithoutChunksOrWithoutWords) {
  EXPECT_THAT(match_list({0, 5}), IsEmpty());
  EXPECT_THAT(match_list({5, 0}), IsEmpty());
  EXPECT_THAT(match_list({2, 2}), IsEmpty());  // nothing was compared
}

TEST(MatchList, FindsRandomReadingsOfLongLists) {
  Random random{7};
  for (int trial = 0; trial < 50; ++trial) {
    constexpr std::size_t kWords = 120;
    std::vector<std::optional<std::size_t>> said;
    for (std::size_t word = 0; word < kWords; ++word) {
      if (random.below(15) == 0) said.emplace_back();
      if (random.below(15) == 0) continue;
      const auto takes = random.below(10) == 0 ? 2U : 1U;
      for (unsigned take = 0; take < takes; ++take) said.emplace_back(word);
    }
    const auto matches = match_list(fits_of(said, kWords, random));
    const auto right = std::ranges::count_if(
        matches, [&](const Match& match) { return said[match.chunk] == match.word; });
    const auto spoken =
        std::ranges::count_if(said, [](const auto& word) { return word.has_value(); });
    EXPECT_EQ(right, spoken) << "trial " << trial;
    EXPECT_TRUE(std::ranges::is_sorted(matches, {}, &Match::chunk));
    EXPECT_TRUE(std::ranges::is_sorted(matches, {}, &Match::word));
  }
}

/// The best sum of any way through, tried one by one.
float best_by_trying(const ChunkWordFits& fits,
                     const MatchCosts& costs,
                     std::size_t chunk,
                     std::size_t word) {
  if (chunk == fits.chunks()) {
    return -costs.skipped_word * static_cast<float>(fits.words() - word);
  }
  const auto worth = [&](float fit) {
    return fit == ChunkWordFits::kNotCompared ? fit : std::max(costs.worst, costs.match + fit);
  };
  float best = best_by_trying(fits, costs, chunk + 1, word) - costs.skipped_chunk;
  if (word > 0) {
    best = std::max(best,
                    best_by_trying(fits, costs, chunk + 1, word) +
                        worth(fits.one(chunk, word - 1)) - costs.again);
  }
  if (word < fits.words()) {
    best = std::max(best, best_by_trying(fits, costs, chunk, word + 1) - costs.skipped_word);
    best = std::max(
        best, best_by_trying(fits, costs, chunk + 1, word + 1) + worth(fits.one(chunk, word)));
  }
  if (word + 1 < fits.words()) {
    best = std::max(
        best,
        best_by_trying(fits, costs, chunk + 1, word + 2) + 2.0F * worth(fits.two(chunk, word)));
  }
  return best;
}

TEST(MatchList, IsAsGoodAsTheBestOfAllWays) {
  Random random{8};
  const MatchCosts costs;
  for (int trial = 0; trial < 200; ++trial) {
    ChunkWordFits fits{1 + random.below(4), 1 + random.below(4)};
    for (std::size_t chunk = 0; chunk < fits.chunks(); ++chunk) {
      for (std::size_t word = 0; word < fits.words(); ++word) {
        fits.one(chunk, word) = static_cast<float>(-5.0 * random.uniform());
        if (word + 1 < fits.words())
          fits.two(chunk, word) = static_cast<float>(-5.0 * random.uniform());
      }
    }
    float sum = -costs.skipped_chunk * static_cast<float>(fits.chunks()) -
                costs.skipped_word * static_cast<float>(fits.words());
    std::optional<std::size_t> last;
    for (const auto& match : match_list(fits)) {
      const bool again = last == match.word && !match.with_next;
      const float fit =
          match.with_next ? fits.two(match.chunk, match.word) : fits.one(match.chunk, match.word);
      const float words = match.with_next ? 2.0F : 1.0F;
      sum += words * std::max(costs.worst, costs.match + fit) + costs.skipped_chunk;
      sum += again ? -costs.again : words * costs.skipped_word;
      last = match.word + (match.with_next ? 1 : 0);
    }
    EXPECT_NEAR(sum, best_by_trying(fits, costs, 0, 0), 1e-4) << "trial " << trial;
  }
}

}  // namespace
}  // namespace bimodal

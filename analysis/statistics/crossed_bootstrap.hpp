#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/statistics/interval.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal::analysis {

/// What one participant did with one word.
struct CrossedCell {
  std::uint32_t participant = 0;  ///< index
  std::uint32_t word = 0;         ///< index
  std::uint32_t successes = 0;
  std::uint32_t trials = 0;
};

/// Proportions over participants crossed with words. Trials of one participant, and trials of one
/// word, are alike, so that resampling trials (or any interval for independent trials) is too
/// narrow by far. Here participants and words are both drawn with replacement, independently, and a
/// cell counts as often as its participant was drawn, times as often as its word was (the
/// "pigeonhole" bootstrap: Owen, 2007, Ann. Appl. Stat. 1, 386-411, who shows that it errs on the
/// wide side).
class CrossedBootstrap {
 public:
  struct Options {
    int draws = 2000;
    Seed seed = 1;
  };

  CrossedBootstrap(std::size_t participants, std::size_t words, Options options);

  /// Proportion of successes in each draw; a draw that meets no trial at all is left out.
  [[nodiscard]] std::vector<double> replicates(std::span<const CrossedCell> cells) const;

  /// The same draw by draw, absent where it meets no trial: for what two conditions, of which the
  /// same participants and words are drawn, have to do with each other.
  [[nodiscard]] std::vector<std::optional<double>> replicates_by_draw(
      std::span<const CrossedCell> cells) const;

  /// The percentile interval. Absent where the bootstrap has nothing to say: no trials, all or none
  /// successes, or more than 1 % of the draws without any trial.
  [[nodiscard]] std::optional<Interval> interval(std::span<const CrossedCell> cells,
                                                 double level = 0.95) const;

 private:
  std::size_t participants_;
  std::size_t words_;
  std::size_t draws_;
  std::vector<std::uint32_t> participant_counts_;  ///< draw by draw, participants_ each
  std::vector<std::uint32_t> word_counts_;         ///< draw by draw, words_ each
};

/// The middle of replicates that a bootstrap gave: their order statistics ceil(alpha/2 B) and
/// ceil((1 - alpha/2) B), alpha = 1 - level. At least one replicate.
[[nodiscard]] Interval percentile_interval(std::vector<double> replicates, double level = 0.95);

}  // namespace bimodal::analysis

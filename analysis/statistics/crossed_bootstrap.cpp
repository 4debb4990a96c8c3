#include "analysis/statistics/crossed_bootstrap.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace bimodal::analysis {

namespace {

std::vector<std::uint32_t> draw_counts(std::size_t items, std::size_t draws, Random& random) {
  std::vector<std::uint32_t> counts(items * draws, 0);
  for (std::size_t draw = 0; draw < draws; ++draw) {
    for (std::size_t i = 0; i < items; ++i) ++counts[draw * items + random.below(items)];
  }
  return counts;
}

/// Both sums of a cell in one word, so that one multiplication weighs both.
constexpr unsigned kTrialsShift = 32;

/// The words that one participant met, next to each other in memory.
struct Row {
  std::uint32_t participant = 0;
  std::vector<std::uint32_t> words;
  std::vector<std::uint64_t> sums;  ///< trials << 32 | successes
};

std::vector<Row> sort_into_rows(std::span<const CrossedCell> cells, std::size_t participants) {
  std::vector<Row> rows(participants);
  for (std::size_t i = 0; i < participants; ++i)
    rows[i].participant = static_cast<std::uint32_t>(i);
  for (const auto& cell : cells) {
    if (cell.trials == 0) continue;
    auto& row = rows[cell.participant];
    row.words.push_back(cell.word);
    row.sums.push_back(std::uint64_t{cell.trials} << kTrialsShift | cell.successes);
  }
  std::erase_if(rows, [](const Row& row) { return row.words.empty(); });
  return rows;
}

}  // namespace

CrossedBootstrap::CrossedBootstrap(std::size_t participants, std::size_t words, Options options)
    : participants_{participants},
      words_{words},
      draws_{static_cast<std::size_t>(std::max(options.draws, 0))} {
  Random for_participants{derive_seed(options.seed, "participants")};
  Random for_words{derive_seed(options.seed, "words")};
  participant_counts_ = draw_counts(participants_, draws_, for_participants);
  word_counts_ = draw_counts(words_, draws_, for_words);
}

std::vector<double> CrossedBootstrap::replicates(std::span<const CrossedCell> cells) const {
  std::vector<double> proportions;
  for (const auto& drawn : replicates_by_draw(cells)) {
    if (drawn) proportions.push_back(*drawn);
  }
  return proportions;
}

std::vector<std::optional<double>> CrossedBootstrap::replicates_by_draw(
    std::span<const CrossedCell> cells) const {
  const auto rows = sort_into_rows(cells, participants_);
  std::vector<std::optional<double>> proportions(draws_);
  for (std::size_t draw = 0; draw < draws_; ++draw) {
    const auto* const participant_count = participant_counts_.data() + draw * participants_;
    const auto* const word_count = word_counts_.data() + draw * words_;
    std::uint64_t successes = 0;
    std::uint64_t trials = 0;
    for (const auto& row : rows) {
      const std::uint64_t times = participant_count[row.participant];
      if (times == 0) continue;
      std::uint64_t sums = 0;
      for (std::size_t i = 0; i < row.words.size(); ++i) {
        sums += row.sums[i] * word_count[row.words[i]];
      }
      successes += times * (sums & 0xffffffffU);
      trials += times * (sums >> kTrialsShift);
    }
    if (trials == 0) continue;
    proportions[draw] = static_cast<double>(successes) / static_cast<double>(trials);
  }
  return proportions;
}

std::optional<Interval> CrossedBootstrap::interval(std::span<const CrossedCell> cells,
                                                   double level) const {
  std::uint64_t successes = 0;
  std::uint64_t trials = 0;
  for (const auto& cell : cells) {
    successes += cell.successes;
    trials += cell.trials;
  }
  if (successes == 0 || successes == trials) return std::nullopt;
  auto proportions = replicates(cells);
  if (draws_ == 0 || 100 * (draws_ - proportions.size()) > draws_) return std::nullopt;
  return percentile_interval(std::move(proportions), level);
}

Interval percentile_interval(std::vector<double> replicates, double level) {
  assert(!replicates.empty());
  std::ranges::sort(replicates);
  const auto order_statistic = [&](double share) {
    const double rank = std::ceil(share * static_cast<double>(replicates.size()) - 1e-9);
    return replicates[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
  };
  const double tail = (1.0 - level) / 2.0;
  return {order_statistic(tail), order_statistic(1.0 - tail)};
}

}  // namespace bimodal::analysis

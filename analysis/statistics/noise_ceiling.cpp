#include "analysis/statistics/noise_ceiling.hpp"

#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "analysis/statistics/correlation.hpp"
#include "analysis/statistics/matrix_comparison.hpp"

namespace bimodal::analysis {

namespace {

/// The mean of those correlations that exist.
class Mean {
 public:
  void add(const std::optional<double>& value) {
    if (!value) return;
    sum_ += *value;
    ++count_;
  }

  [[nodiscard]] std::optional<double> value() const {
    if (count_ == 0) return std::nullopt;
    return sum_ / static_cast<double>(count_);
  }

 private:
  double sum_ = 0.0;
  std::int64_t count_ = 0;
};

NoiseCeiling sum_up(NoiseCeiling ceiling, const Mean& within, const Mean& across) {
  ceiling.within = within.value();
  ceiling.across = across.value();
  if (!ceiling.within || *ceiling.within <= 0.0) return ceiling;
  if (ceiling.across) ceiling.share = *ceiling.across / *ceiling.within;
  ceiling.corrected = spearman_brown(*ceiling.within);
  return ceiling;
}

using Halves = std::pair<ConfusionMatrix, ConfusionMatrix>;

Halves split_responses(const ConfusionMatrix& matrix, Random& random) {
  Halves halves{{matrix.stimuli(), matrix.responses()}, {matrix.stimuli(), matrix.responses()}};
  std::vector<std::size_t> given;
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    given.clear();
    for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
      given.insert(given.end(), static_cast<std::size_t>(std::llround(matrix.count(i, j))), j);
    }
    shuffle(std::span{given}, random);
    // of an odd number the one response too many goes to either half
    const auto extra = given.size() % 2 == 1 ? random.below(2) : 0;
    const auto middle = given.size() / 2 + extra;
    for (std::size_t k = 0; k < given.size(); ++k) {
      auto& half = k < middle ? halves.first : halves.second;
      half.add(matrix.stimuli()[i], matrix.responses()[given[k]]);
    }
  }
  return halves;
}

void add_to(ConfusionMatrix& sum, const ConfusionMatrix& matrix) {
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
      if (matrix.count(i, j) > 0.0) {
        sum.add(matrix.stimuli()[i], matrix.responses()[j], matrix.count(i, j));
      }
    }
  }
}

}  // namespace

NoiseCeiling noise_ceiling(const ConfusionMatrix& one,
                           const ConfusionMatrix& other,
                           bool off_diagonal_only,
                           std::int64_t splits,
                           Seed seed) {
  Random random{derive_seed(seed, "halves")};
  Mean within;
  Mean across;
  for (std::int64_t split = 0; split < splits; ++split) {
    const auto ones = split_responses(one, random);
    const auto others = split_responses(other, random);
    within.add(agreement_of_cells(ones.first, ones.second, off_diagonal_only).pearson);
    across.add(agreement_of_cells(ones.first, others.second, off_diagonal_only).pearson);
  }
  return sum_up({.splits = splits, .by_participants = false}, within, across);
}

NoiseCeiling noise_ceiling(std::span<const ParticipantConfusions> participants,
                           bool off_diagonal_only,
                           std::int64_t splits,
                           Seed seed) {
  assert(participants.size() >= 4);
  Random random{derive_seed(seed, "halves of participants")};
  const auto& labels = participants.front().one;
  std::vector<std::size_t> order(participants.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Mean within;
  Mean across;
  for (std::int64_t split = 0; split < splits; ++split) {
    shuffle(std::span{order}, random);
    const ConfusionMatrix empty{labels.stimuli(), labels.responses()};
    ConfusionMatrix first = empty;
    ConfusionMatrix second = empty;
    ConfusionMatrix other_second = empty;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const auto& participant = participants[order[k]];
      if (k < order.size() / 2) {
        add_to(first, participant.one);
      } else {
        add_to(second, participant.one);
        add_to(other_second, participant.other);
      }
    }
    within.add(agreement_of_cells(first, second, off_diagonal_only).pearson);
    across.add(agreement_of_cells(first, other_second, off_diagonal_only).pearson);
  }
  return sum_up({.splits = splits, .by_participants = true}, within, across);
}

}  // namespace bimodal::analysis

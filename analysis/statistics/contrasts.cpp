#include "analysis/statistics/contrasts.hpp"

#include <algorithm>
#include <cassert>

#include "analysis/statistics/dissimilarity.hpp"

namespace bimodal::analysis {

namespace {

/// Only the rows presented in both conditions.
ConfusionMatrix presented_in_both(const ConfusionMatrix& matrix, const ConfusionMatrix& other) {
  std::vector<std::string> stimuli;
  std::vector<double> counts;
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    if (matrix.row_total(i) <= 0.0 || other.row_total(i) <= 0.0) continue;
    stimuli.push_back(matrix.stimuli()[i]);
    for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
      counts.push_back(matrix.count(i, j));
    }
  }
  return {std::move(stimuli), matrix.responses(), std::move(counts)};
}

}  // namespace

std::vector<Contrast> rank_contrasts(const ConfusionMatrix& one, const ConfusionMatrix& other) {
  assert(one.stimuli() == other.stimuli() && one.responses() == other.responses());
  const auto ones = presented_in_both(one, other);
  const auto others = presented_in_both(other, one);
  const auto apart_one = dissimilarities(ones, DissimilarityMeasure::Phi);
  const auto apart_other = dissimilarities(others, DissimilarityMeasure::Phi);
  const auto alike_one = dissimilarities(ones, DissimilarityMeasure::Confusion);
  const auto alike_other = dissimilarities(others, DissimilarityMeasure::Confusion);
  std::vector<Contrast> contrasts;
  for (std::size_t i = 0; i < ones.stimuli().size(); ++i) {
    for (std::size_t j = i + 1; j < ones.stimuli().size(); ++j) {
      contrasts.push_back({.stimulus = ones.stimuli()[i],
                           .counterpart = ones.stimuli()[j],
                           .one = apart_one.between(i, j),
                           .other = apart_other.between(i, j),
                           .confused_one = 1.0 - alike_one.between(i, j),
                           .confused_other = 1.0 - alike_other.between(i, j)});
    }
  }
  std::ranges::stable_sort(
      contrasts, std::ranges::greater{}, [](const Contrast& contrast) { return contrast.loss(); });
  return contrasts;
}

}  // namespace bimodal::analysis

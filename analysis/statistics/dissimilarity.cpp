#include "analysis/statistics/dissimilarity.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

namespace bimodal::analysis {

namespace {

double phi(const ConfusionMatrix& matrix, std::size_t one, std::size_t other) {
  const auto row_one = matrix.row_total(one);
  const auto row_other = matrix.row_total(other);
  const double total = row_one + row_other;
  double chi_square = 0.0;
  for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
    const auto a = matrix.count(one, j);
    const auto b = matrix.count(other, j);
    if (a + b == 0.0) continue;
    const double expected_a = row_one * (a + b) / total;
    const double expected_b = row_other * (a + b) / total;
    chi_square += (a - expected_a) * (a - expected_a) / expected_a +
                  (b - expected_b) * (b - expected_b) / expected_b;
  }
  return std::sqrt(chi_square / total);
}

/// Of the responses to a stimulus, those that name another; 0 where there is no such response.
double answered_for(const ConfusionMatrix& matrix, std::size_t stimulus, std::size_t named) {
  const auto found = std::ranges::find(matrix.responses(), matrix.stimuli()[named]);
  if (found == matrix.responses().end()) return 0.0;
  const auto column = static_cast<std::size_t>(found - matrix.responses().begin());
  return matrix.proportion(stimulus, column).value_or(0.0);
}

}  // namespace

Dissimilarities::Dissimilarities(std::vector<std::string> labels)
    : labels_{std::move(labels)}, values_(labels_.size() * labels_.size()) {}

double Dissimilarities::between(std::size_t one, std::size_t other) const {
  assert(one < size() && other < size());
  return values_[one * size() + other];
}

void Dissimilarities::set(std::size_t one, std::size_t other, double value) {
  assert(one < size() && other < size() && one != other && value >= 0.0);
  values_[one * size() + other] = values_[other * size() + one] = value;
}

Dissimilarities dissimilarities(const ConfusionMatrix& matrix, DissimilarityMeasure measure) {
  std::vector<std::size_t> rows;
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    if (matrix.row_total(i) == 0) continue;
    rows.push_back(i);
    labels.push_back(matrix.stimuli()[i]);
  }
  Dissimilarities found{std::move(labels)};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double value = measure == DissimilarityMeasure::Phi
                               ? phi(matrix, rows[i], rows[j])
                               : 1.0 - (answered_for(matrix, rows[i], rows[j]) +
                                        answered_for(matrix, rows[j], rows[i])) /
                                           2.0;
      found.set(i, j, value);
    }
  }
  return found;
}

}  // namespace bimodal::analysis

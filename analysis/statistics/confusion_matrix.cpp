#include "analysis/statistics/confusion_matrix.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "analysis/statistics/correlation.hpp"

namespace bimodal::analysis {

namespace {

std::size_t index_of(const std::vector<std::string>& labels, std::string_view label) {
  const auto found = std::ranges::find(labels, label);
  assert(found != labels.end());
  return static_cast<std::size_t>(found - labels.begin());
}

/// Responses that are not ignored and were given in one of the two, or are a stimulus of both; so
/// that a third condition, with which they share their labels, does not change their likeness.
std::vector<std::size_t> compared_columns(const ConfusionMatrix& one,
                                          const ConfusionMatrix& other,
                                          const std::vector<std::string>& ignored) {
  std::vector<std::size_t> columns;
  for (std::size_t j = 0; j < one.responses().size(); ++j) {
    const auto& response = one.responses()[j];
    if (std::ranges::find(ignored, response) != ignored.end()) continue;
    bool wanted = false;
    for (std::size_t i = 0; i < one.stimuli().size(); ++i) {
      const bool in_both = one.row_total(i) > 0 && other.row_total(i) > 0;
      wanted = wanted || one.count(i, j) + other.count(i, j) > 0 ||
               (in_both && one.stimuli()[i] == response);
    }
    if (wanted) columns.push_back(j);
  }
  return columns;
}

double sum_over(const ConfusionMatrix& matrix,
                std::size_t stimulus,
                const std::vector<std::size_t>& columns) {
  double sum = 0.0;
  for (const std::size_t j : columns) sum += matrix.count(stimulus, j);
  return sum;
}

}  // namespace

ConfusionMatrix::ConfusionMatrix(std::vector<std::string> stimuli,
                                 std::vector<std::string> responses)
    : stimuli_{std::move(stimuli)},
      responses_{std::move(responses)},
      counts_(stimuli_.size() * responses_.size(), 0.0) {}

ConfusionMatrix::ConfusionMatrix(std::vector<std::string> stimuli,
                                 std::vector<std::string> responses,
                                 std::vector<double> counts)
    : stimuli_{std::move(stimuli)}, responses_{std::move(responses)}, counts_{std::move(counts)} {
  assert(counts_.size() == stimuli_.size() * responses_.size());
}

void ConfusionMatrix::add(std::string_view stimulus, std::string_view response, double weight) {
  counts_[index_of(stimuli_, stimulus) * responses_.size() + index_of(responses_, response)] +=
      weight;
}

double ConfusionMatrix::count(std::size_t stimulus, std::size_t response) const {
  assert(stimulus < stimuli_.size() && response < responses_.size());
  return counts_[stimulus * responses_.size() + response];
}

double ConfusionMatrix::row_total(std::size_t stimulus) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < responses_.size(); ++i) sum += count(stimulus, i);
  return sum;
}

double ConfusionMatrix::total() const {
  return std::accumulate(counts_.begin(), counts_.end(), 0.0);
}

double ConfusionMatrix::correct() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < stimuli_.size(); ++i) {
    for (std::size_t j = 0; j < responses_.size(); ++j) {
      if (stimuli_[i] == responses_[j]) sum += count(i, j);
    }
  }
  return sum;
}

std::optional<double> ConfusionMatrix::proportion(std::size_t stimulus,
                                                  std::size_t response) const {
  const auto all = row_total(stimulus);
  if (all == 0) return std::nullopt;
  return count(stimulus, response) / all;
}

Likeness compare_errors(const ConfusionMatrix& one,
                        const ConfusionMatrix& other,
                        const std::vector<std::string>& ignored) {
  assert(one.stimuli() == other.stimuli() && one.responses() == other.responses());
  const auto columns = compared_columns(one, other, ignored);
  std::vector<double> ones;
  std::vector<double> others;
  Likeness likeness;
  double squares = 0.0;
  for (std::size_t i = 0; i < one.stimuli().size(); ++i) {
    const auto row_one = sum_over(one, i, columns);
    const auto row_other = sum_over(other, i, columns);
    if (row_one == 0 || row_other == 0) continue;
    for (const std::size_t j : columns) {
      if (one.responses()[j] == one.stimuli()[i]) continue;
      const double x = one.count(i, j) / row_one;
      const double y = other.count(i, j) / row_other;
      ones.push_back(x);
      others.push_back(y);
      squares += (x - y) * (x - y);
      if (one.count(i, j) + other.count(i, j) > 0) ++likeness.cells_used;
    }
  }
  likeness.cells = ones.size();
  likeness.correlation = pearson(ones, others);
  if (!ones.empty()) {
    likeness.rms_deviation = std::sqrt(squares / static_cast<double>(ones.size()));
  }
  return likeness;
}

}  // namespace bimodal::analysis

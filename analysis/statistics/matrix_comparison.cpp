#include "analysis/statistics/matrix_comparison.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include <boost/math/distributions/chi_squared.hpp>

#include "analysis/statistics/correlation.hpp"

namespace bimodal::analysis {

namespace {

std::vector<std::string> both(const std::vector<std::string>& ones,
                              const std::vector<std::string>& others) {
  auto all = ones;
  for (const auto& other : others) {
    if (std::ranges::find(ones, other) == ones.end()) all.push_back(other);
  }
  return all;
}

ConfusionMatrix spread(const ConfusionMatrix& matrix,
                       const std::vector<std::string>& stimuli,
                       const std::vector<std::string>& responses) {
  ConfusionMatrix wide{stimuli, responses};
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
      if (matrix.count(i, j) > 0.0) {
        wide.add(matrix.stimuli()[i], matrix.responses()[j], matrix.count(i, j));
      }
    }
  }
  return wide;
}

/// p log2(p / m), 0 where there is no p.
double part_of_divergence(double p, double m) {
  return p > 0.0 ? p * std::log2(p / m) : 0.0;
}

RowComparison compare_row(const ConfusionMatrix& one,
                          const ConfusionMatrix& other,
                          std::size_t row,
                          double& g) {
  RowComparison found{
      .stimulus = one.stimuli()[row], .n_one = one.row_total(row), .n_other = other.row_total(row)};
  const double n = found.n_one + found.n_other;
  std::int64_t columns = 0;
  for (std::size_t j = 0; j < one.responses().size(); ++j) {
    const double a = one.count(row, j);
    const double b = other.count(row, j);
    if (a + b <= 0.0) continue;
    ++columns;
    const double p = a / found.n_one;
    const double q = b / found.n_other;
    const double middle = (p + q) / 2.0;
    found.divergence += (part_of_divergence(p, middle) + part_of_divergence(q, middle)) / 2.0;
    const double expected_a = (a + b) * found.n_one / n;
    const double expected_b = (a + b) * found.n_other / n;
    found.chi_square += (a - expected_a) * (a - expected_a) / expected_a +
                        (b - expected_b) * (b - expected_b) / expected_b;
    if (a > 0.0) g += 2.0 * a * std::log(a / expected_a);
    if (b > 0.0) g += 2.0 * b * std::log(b / expected_b);
  }
  found.degrees = columns - 1;
  return found;
}

/// Responses, and correct ones, to stimuli that the other matrix has too.
struct Shared {
  double n = 0.0;
  double correct = 0.0;

  [[nodiscard]] std::optional<double> proportion() const {
    if (n <= 0.0) return std::nullopt;
    return correct / n;
  }
};

Shared shared_part(const ConfusionMatrix& matrix, const ConfusionMatrix& other) {
  Shared part;
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    if (other.row_total(i) <= 0.0) continue;
    part.n += matrix.row_total(i);
    for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
      if (matrix.responses()[j] == matrix.stimuli()[i]) part.correct += matrix.count(i, j);
    }
  }
  return part;
}

/// Places in `labels` of those that are in `others` too, and their places there.
std::pair<std::vector<std::size_t>, std::vector<std::size_t>> shared_places(
    const std::vector<std::string>& labels, const std::vector<std::string>& others) {
  std::pair<std::vector<std::size_t>, std::vector<std::size_t>> places;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto found = std::ranges::find(others, labels[i]);
    if (found == others.end()) continue;
    places.first.push_back(i);
    places.second.push_back(static_cast<std::size_t>(found - others.begin()));
  }
  return places;
}

/// The lower triangle, row by row, of the things at `places`.
std::vector<double> triangle(const Dissimilarities& unlike,
                             const std::vector<std::size_t>& places) {
  std::vector<double> values;
  for (std::size_t i = 1; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) values.push_back(unlike.between(places[i], places[j]));
  }
  return values;
}

/// At most `limit + 1`.
std::int64_t factorial_up_to(std::size_t n, std::int64_t limit) {
  std::int64_t product = 1;
  for (std::size_t k = 2; k <= n && product <= limit; ++k) product *= static_cast<std::int64_t>(k);
  return product;
}

}  // namespace

std::pair<ConfusionMatrix, ConfusionMatrix> with_common_labels(const ConfusionMatrix& one,
                                                               const ConfusionMatrix& other) {
  const auto stimuli = both(one.stimuli(), other.stimuli());
  const auto responses = both(one.responses(), other.responses());
  return {spread(one, stimuli, responses), spread(other, stimuli, responses)};
}

CellAgreement agreement_of_cells(const ConfusionMatrix& one,
                                 const ConfusionMatrix& other,
                                 bool off_diagonal_only) {
  assert(one.stimuli() == other.stimuli() && one.responses() == other.responses());
  std::vector<double> ones;
  std::vector<double> others;
  double squares = 0.0;
  for (std::size_t i = 0; i < one.stimuli().size(); ++i) {
    const double n_one = one.row_total(i);
    const double n_other = other.row_total(i);
    if (n_one <= 0.0 || n_other <= 0.0) continue;
    for (std::size_t j = 0; j < one.responses().size(); ++j) {
      if (off_diagonal_only && one.responses()[j] == one.stimuli()[i]) continue;
      ones.push_back(one.count(i, j) / n_one);
      others.push_back(other.count(i, j) / n_other);
      squares += (ones.back() - others.back()) * (ones.back() - others.back());
    }
  }
  CellAgreement found{.cells = ones.size(),
                      .pearson = pearson(ones, others),
                      .spearman = spearman(ones, others),
                      .rms_difference = std::nullopt};
  if (!ones.empty()) found.rms_difference = std::sqrt(squares / static_cast<double>(ones.size()));
  return found;
}

MatrixComparison compare_matrices(const ConfusionMatrix& one, const ConfusionMatrix& other) {
  assert(one.stimuli() == other.stimuli() && one.responses() == other.responses());
  const auto part_one = shared_part(one, other);
  const auto part_other = shared_part(other, one);
  MatrixComparison found{.n_one = part_one.n,
                         .n_other = part_other.n,
                         .correct_one = part_one.proportion(),
                         .correct_other = part_other.proportion(),
                         .all = agreement_of_cells(one, other, false),
                         .off_diagonal = agreement_of_cells(one, other, true)};
  if (found.correct_one.value_or(0.0) > 0.0 && found.correct_other) {
    found.accuracy_ratio = *found.correct_other / *found.correct_one;
  }
  for (std::size_t i = 0; i < one.stimuli().size(); ++i) {
    if (one.row_total(i) > 0.0 && other.row_total(i) > 0.0) {
      found.rows.push_back(compare_row(one, other, i, found.g));
      found.chi_square += found.rows.back().chi_square;
      found.degrees += found.rows.back().degrees;
    } else if (one.row_total(i) + other.row_total(i) > 0.0) {
      found.not_compared.push_back(one.stimuli()[i]);
    }
  }
  if (found.degrees > 0) {
    const boost::math::chi_squared distribution{static_cast<double>(found.degrees)};
    found.chi_square_p = boost::math::cdf(boost::math::complement(distribution, found.chi_square));
  }
  return found;
}

std::optional<Mantel> mantel(const Dissimilarities& one,
                             const Dissimilarities& other,
                             std::int64_t permutations,
                             Seed seed) {
  auto places = shared_places(one.labels(), other.labels());
  const auto& ones = places.first;
  auto& others = places.second;
  if (ones.size() < 3) return std::nullopt;
  const auto fixed = triangle(one, ones);
  const auto observed = pearson(fixed, triangle(other, others));
  if (!observed) return std::nullopt;
  Mantel found{.stimuli = ones.size(), .r = *observed, .permutations = permutations};
  const auto orders = factorial_up_to(ones.size(), permutations);
  found.enumerated = orders <= permutations;
  std::int64_t as_large = 0;
  const auto judge = [&] {
    constexpr double kSlack = 1e-12;  // the same sum in another order
    if (pearson(fixed, triangle(other, others)).value_or(-1.0) >= *observed - kSlack) ++as_large;
  };
  if (found.enumerated) {
    found.permutations = orders;
    std::ranges::sort(others);
    do {
      judge();
    } while (std::ranges::next_permutation(others).found);
    found.p = static_cast<double>(as_large) / static_cast<double>(orders);
    return found;
  }
  Random random{derive_seed(seed, "mantel")};
  for (std::int64_t draw = 0; draw < permutations; ++draw) {
    shuffle(std::span{others}, random);
    judge();
  }
  found.p = (1.0 + static_cast<double>(as_large)) / (1.0 + static_cast<double>(permutations));
  return found;
}

}  // namespace bimodal::analysis

#include "analysis/statistics/matrix_sampler.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace bimodal::analysis {

namespace {

constexpr double kScale = 4294967296.0;  // 2^32

/// One row's table: columns that have less than their share take the rest from one that has more.
void make_aliases(const double* proportions,
                  std::size_t columns,
                  std::uint32_t* aliases,
                  std::uint64_t* thresholds) {
  std::vector<double> left(proportions, proportions + columns);
  double sum = 0.0;
  for (const double value : left) sum += value;
  std::vector<std::uint32_t> poor;
  std::vector<std::uint32_t> rich;
  for (std::uint32_t j = 0; j < columns; ++j) {
    left[j] = sum > 0.0 ? left[j] * static_cast<double>(columns) / sum : 1.0;
    aliases[j] = j;
    thresholds[j] = static_cast<std::uint64_t>(kScale);
    (left[j] < 1.0 ? poor : rich).push_back(j);
  }
  while (!poor.empty() && !rich.empty()) {
    const auto taker = poor.back();
    const auto giver = rich.back();
    poor.pop_back();
    thresholds[taker] = static_cast<std::uint64_t>(left[taker] * kScale);
    aliases[taker] = giver;
    left[giver] -= 1.0 - left[taker];
    if (left[giver] >= 1.0) continue;
    rich.pop_back();
    poor.push_back(giver);
  }
}

}  // namespace

MatrixSampler::MatrixSampler(std::vector<double> proportions,
                             std::vector<std::int64_t> row_totals,
                             std::size_t columns)
    : row_totals_{std::move(row_totals)},
      columns_{columns},
      aliases_(proportions.size()),
      thresholds_(proportions.size()) {
  assert(proportions.size() == row_totals_.size() * columns);
  for (std::size_t i = 0; i < row_totals_.size(); ++i) {
    const auto row = i * columns;
    make_aliases(
        proportions.data() + row, columns, aliases_.data() + row, thresholds_.data() + row);
  }
}

void MatrixSampler::draw(Random& random, CellCounts& counts) const {
  counts.assign(row_totals_.size() * columns_, 0);
  for (std::size_t i = 0; i < row_totals_.size(); ++i) {
    const auto row = i * columns_;
    for (std::int64_t k = 0; k < row_totals_[i]; ++k) {
      const auto bits = random.bits();
      // the upper half chooses a column (its bias is below 1e-6 for fewer than 4,000 columns)
      const auto column = static_cast<std::size_t>(((bits >> 32U) * columns_) >> 32U);
      const bool itself = (bits & 0xffffffffU) < thresholds_[row + column];
      ++counts[row + (itself ? column : aliases_[row + column])];
    }
  }
}

std::vector<double> smoothed_proportions(const CellCounts& counts, std::size_t columns) {
  std::vector<double> given(columns, 0.5);
  for (std::size_t cell = 0; cell < counts.size(); ++cell) given[cell % columns] += counts[cell];
  std::vector<double> proportions(counts.size(), 0.0);
  for (std::size_t row = 0; row < counts.size(); row += columns) {
    double n = 0.0;
    double once = 0.0;
    double unseen = 0.0;
    for (std::size_t j = 0; j < columns; ++j) {
      n += counts[row + j];
      once += counts[row + j] == 1 ? 1.0 : 0.0;
      unseen += counts[row + j] == 0 ? given[j] : 0.0;
    }
    if (n <= 0.0) continue;
    const double kept_back = unseen > 0.0 ? std::min(0.5, once / n) : 0.0;
    for (std::size_t j = 0; j < columns; ++j) {
      proportions[row + j] = counts[row + j] == 0
                                 ? kept_back * (unseen > 0.0 ? given[j] / unseen : 0.0)
                                 : (1.0 - kept_back) * counts[row + j] / n;
    }
  }
  return proportions;
}

}  // namespace bimodal::analysis

#include "analysis/statistics/matrix_sampler.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace bimodal::analysis {

namespace {

constexpr double kScale = 4294967296.0;  // 2^32

}  // namespace

/// Columns that have less than their share take the rest from one that has more.
void MatrixSampler::make_aliases(std::span<const double> proportions, std::span<Column> row) {
  const auto columns = static_cast<double>(row.size());
  std::vector<double> left(proportions.begin(), proportions.end());
  double sum = 0.0;
  for (const double value : left) sum += value;
  std::vector<std::uint32_t> poor;
  std::vector<std::uint32_t> rich;
  for (std::uint32_t j = 0; j < row.size(); ++j) {
    left[j] = sum > 0.0 ? left[j] * columns / sum : 1.0;
    row[j] = {.threshold = static_cast<std::uint64_t>(kScale), .drawn = {j, j}};
    (left[j] < 1.0 ? poor : rich).push_back(j);
  }
  while (!poor.empty() && !rich.empty()) {
    const auto taker = poor.back();
    const auto giver = rich.back();
    poor.pop_back();
    row[taker] = {.threshold = static_cast<std::uint64_t>(left[taker] * kScale),
                  .drawn = {giver, taker}};
    left[giver] -= 1.0 - left[taker];
    if (left[giver] >= 1.0) continue;
    rich.pop_back();
    poor.push_back(giver);
  }
}

MatrixSampler::MatrixSampler(std::vector<double> proportions,
                             std::vector<std::int64_t> row_totals,
                             std::size_t columns)
    : row_totals_{std::move(row_totals)}, columns_{columns}, table_(proportions.size()) {
  assert(proportions.size() == row_totals_.size() * columns);
  const std::span<const double> all{proportions};
  for (std::size_t i = 0; i < row_totals_.size(); ++i) {
    const auto row = i * columns;
    make_aliases(all.subspan(row, columns), std::span{table_}.subspan(row, columns));
  }
}

void MatrixSampler::draw(Random& random, CellCounts& counts) const {
  counts.assign(row_totals_.size() * columns_, 0);
  auto bare = random;  // in registers, where no write to the counts can reach it
  for (std::size_t i = 0; i < row_totals_.size(); ++i) {
    const auto* const columns = table_.data() + i * columns_;
    auto* const row = counts.data() + i * columns_;
    for (std::int64_t k = 0; k < row_totals_[i]; ++k) {
      const auto bits = bare.bits();
      // the upper half chooses a column (its bias is below 1e-6 for fewer than 4,000 columns)
      const auto column = static_cast<std::size_t>(((bits >> 32U) * columns_) >> 32U);
      const auto& [threshold, drawn] = columns[column];
      ++row[drawn[(bits & 0xffffffffU) < threshold ? 1 : 0]];
    }
  }
  random = bare;
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

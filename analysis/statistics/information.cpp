#include "analysis/statistics/information.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

namespace bimodal::analysis {

namespace {

/// Of the proportions of counts, in bits, and how many of them occur.
struct Entropy {
  double bits = 0.0;
  std::int64_t occurring = 0;
};

/// H = log2 n - (sum of k log2 k) / n, in which no proportion is rounded.
Entropy entropy(const std::vector<double>& counts, double total) {
  Entropy entropy;
  double sum = 0.0;
  for (const double k : counts) {
    if (k <= 0.0) continue;
    sum += k * std::log2(k);
    ++entropy.occurring;
  }
  entropy.bits = std::max(0.0, std::log2(total) - sum / total);
  return entropy;
}

/// The names of the groups that are not left out, each once.
std::vector<std::string> distinct(const std::vector<std::string>& groups) {
  std::vector<std::string> names;
  for (const auto& group : groups) {
    if (!group.empty() && std::ranges::find(names, group) == names.end()) names.push_back(group);
  }
  return names;
}

std::size_t place_of(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

}  // namespace

std::optional<Information> information(const ConfusionMatrix& matrix) {
  std::vector<double> rows(matrix.stimuli().size());
  std::vector<double> columns(matrix.responses().size());
  std::vector<double> cells;
  cells.reserve(rows.size() * columns.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < columns.size(); ++j) {
      const auto count = matrix.count(i, j);
      rows[i] += count;
      columns[j] += count;
      cells.push_back(count);
    }
  }
  const auto total = matrix.total();
  if (total <= 0.0) return std::nullopt;
  const auto x = entropy(rows, total);
  const auto y = entropy(columns, total);
  const auto xy = entropy(cells, total);
  Information found{.responses = total,
                    .stimulus_entropy = x.bits,
                    .response_entropy = y.bits,
                    .joint_entropy = xy.bits,
                    .transmitted = std::max(0.0, x.bits + y.bits - xy.bits)};
  if (x.occurring > 1) found.relative = found.transmitted / x.bits;
  const double unit = 1.0 / (2.0 * total * std::numbers::ln2);
  const auto times = [unit](std::int64_t count) { return static_cast<double>(count) * unit; };
  found.miller_madow = found.transmitted + times(x.occurring + y.occurring - xy.occurring - 1);
  found.all_cells_possible = found.transmitted - times((x.occurring - 1) * (y.occurring - 1));
  return found;
}

ConfusionMatrix grouped(const ConfusionMatrix& matrix,
                        const std::vector<std::string>& stimulus_groups,
                        const std::vector<std::string>& response_groups) {
  assert(stimulus_groups.size() == matrix.stimuli().size());
  assert(response_groups.size() == matrix.responses().size());
  auto stimuli = distinct(stimulus_groups);
  auto responses = distinct(response_groups);
  std::vector<double> counts(stimuli.size() * responses.size());
  for (std::size_t i = 0; i < stimulus_groups.size(); ++i) {
    if (stimulus_groups[i].empty()) continue;
    const auto row = place_of(stimuli, stimulus_groups[i]) * responses.size();
    for (std::size_t j = 0; j < response_groups.size(); ++j) {
      if (response_groups[j].empty()) continue;
      counts[row + place_of(responses, response_groups[j])] += matrix.count(i, j);
    }
  }
  return {std::move(stimuli), std::move(responses), std::move(counts)};
}

}  // namespace bimodal::analysis

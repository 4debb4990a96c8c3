#include "analysis/statistics/condition_permutation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include "analysis/statistics/condition_dealing.hpp"
#include "analysis/statistics/correlation.hpp"

namespace bimodal::analysis {

namespace {

using Label = ConditionDealing::Label;

/// Sums of the same numbers in another order may differ by so much.
constexpr double kSlack = 1e-9;

/// Counts of both conditions, side by side: [2 x cell + condition].
using Counts = std::vector<std::int32_t>;

struct Tally {
  Counts cells;
  std::array<std::int64_t, 2> trials{};
  std::array<std::int64_t, 2> correct{};
};

/// How far two conditions differ.
struct Statistics {
  double chi_square = 0.0;
  double accuracy_difference = 0.0;
  std::vector<double> differences;  ///< of proportions, cell by cell
};

class Judge {
 public:
  Judge(std::span<const ComparedTrial> trials, std::size_t stimuli, std::size_t responses)
      : stimuli_{stimuli}, responses_{responses} {
    begins_.push_back(0);
    for (const auto& trial : trials) {
      for (const auto cell : trial.cells) cells_.push_back(2 * cell);
      begins_.push_back(cells_.size());
      correct_.push_back(trial.correct ? 1 : 0);
    }
  }

  void count(const std::vector<Label>& labels, Tally& tally) const {
    tally = {.cells = std::move(tally.cells)};
    tally.cells.assign(2 * stimuli_ * responses_, 0);
    for (std::size_t i = 0; i < correct_.size(); ++i) {
      if (labels[i] == Label::Neither) continue;
      const auto condition = static_cast<std::size_t>(labels[i]);
      ++tally.trials.at(condition);
      tally.correct.at(condition) += correct_[i];
      for (auto k = begins_[i]; k < begins_[i + 1]; ++k) ++tally.cells[cells_[k] + condition];
    }
  }

  void judge(const Tally& tally, Statistics& found) const {
    found.chi_square = 0.0;
    found.differences.assign(stimuli_ * responses_, 0.0);
    const auto share = [&](std::size_t condition) {
      const auto n = tally.trials.at(condition);
      return n == 0 ? 0.0
                    : static_cast<double>(tally.correct.at(condition)) / static_cast<double>(n);
    };
    found.accuracy_difference = share(1) - share(0);
    for (std::size_t row = 0; row < stimuli_; ++row) judge_row(tally, row, found);
  }

 private:
  void judge_row(const Tally& tally, std::size_t row, Statistics& found) const {
    const auto* const cells = tally.cells.data() + 2 * row * responses_;
    double n_one = 0.0;
    double n_other = 0.0;
    for (std::size_t j = 0; j < responses_; ++j) {
      n_one += cells[2 * j];
      n_other += cells[2 * j + 1];
    }
    if (n_one <= 0.0 || n_other <= 0.0) return;
    for (std::size_t j = 0; j < responses_; ++j) {
      const double both = cells[2 * j] + cells[2 * j + 1];
      if (both <= 0.0) continue;
      const double difference = cells[2 * j] / n_one - cells[2 * j + 1] / n_other;
      found.differences[row * responses_ + j] = difference;
      // (a - E)^2 / E of both cells together: d^2 times n1 n2 / (a + b)
      found.chi_square += difference * difference * n_one * n_other / both;
    }
  }

  /// The trials' cells one behind the other (twice their index), as they lie fastest in memory.
  std::vector<std::size_t> cells_;
  std::vector<std::size_t> begins_;  ///< of each trial's, and the end
  std::vector<std::uint8_t> correct_;
  std::size_t stimuli_;
  std::size_t responses_;
};

/// How often something as large as what was observed came by chance.
struct Exceedances {
  std::int64_t chi_square = 0;
  std::int64_t accuracy = 0;
  std::vector<std::int64_t> cells;

  void add(const Exceedances& others) {
    chi_square += others.chi_square;
    accuracy += others.accuracy;
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] += others.cells[i];
  }
};

void compare(const Statistics& observed, const Statistics& drawn, Exceedances& exceedances) {
  const auto as_large = [](double value, double limit) {
    return std::abs(value) >= std::abs(limit) - kSlack;
  };
  const double slack = kSlack * std::max(1.0, observed.chi_square);
  if (drawn.chi_square >= observed.chi_square - slack) ++exceedances.chi_square;
  if (as_large(drawn.accuracy_difference, observed.accuracy_difference)) ++exceedances.accuracy;
  for (std::size_t i = 0; i < observed.differences.size(); ++i) {
    exceedances.cells[i] += as_large(drawn.differences[i], observed.differences[i]) ? 1 : 0;
  }
}

/// A number of draws with a random stream of their own, so that it does not matter who makes them.
constexpr std::int64_t kChunk = 50;

Exceedances exceed(const ConditionDealing& dealing,
                   const Judge& judge,
                   const Statistics& observed,
                   std::int64_t permutations,
                   Seed seed) {
  const auto chunks = (permutations + kChunk - 1) / kChunk;
  const auto workers = std::clamp<std::int64_t>(std::thread::hardware_concurrency(), 1, chunks);
  const auto nothing = Exceedances{.cells = std::vector<std::int64_t>(observed.differences.size())};
  std::vector<Exceedances> found(static_cast<std::size_t>(workers), nothing);
  const auto work = [&](std::int64_t worker) {
    std::vector<Label> labels;
    Tally tally;
    Statistics drawn;
    for (auto chunk = worker; chunk < chunks; chunk += workers) {
      Random random{derive_seed(seed, "permutations", {static_cast<std::uint64_t>(chunk)})};
      const auto end = std::min(permutations, (chunk + 1) * kChunk);
      for (auto draw = chunk * kChunk; draw < end; ++draw) {
        dealing.draw(random, labels);
        judge.count(labels, tally);
        judge.judge(tally, drawn);
        compare(observed, drawn, found[static_cast<std::size_t>(worker)]);
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::int64_t worker = 1; worker < workers; ++worker) threads.emplace_back(work, worker);
    work(0);
  }
  for (std::size_t i = 1; i < found.size(); ++i) found.front().add(found[i]);
  return found.front();
}

/// Whether the stimulus has responses in both conditions.
bool is_in_both(const Tally& tally, std::size_t row, std::size_t responses) {
  std::array<std::int64_t, 2> totals{};
  for (std::size_t i = 2 * row * responses; i < 2 * (row + 1) * responses; ++i) {
    totals.at(i % 2) += tally.cells[i];
  }
  return totals[0] > 0 && totals[1] > 0;
}

/// Adjusted over the cells that have one.
std::vector<std::optional<double>> rates_of(const std::vector<std::optional<double>>& p_values) {
  std::vector<double> known;
  for (const auto& p : p_values) {
    if (p) known.push_back(*p);
  }
  const auto adjusted = false_discovery_rates(known);
  std::vector<std::optional<double>> rates(p_values.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < p_values.size(); ++i) {
    if (p_values[i]) rates[i] = adjusted[next++];
  }
  return rates;
}

}  // namespace

std::string_view name(Randomisation randomisation) {
  constexpr std::array<std::string_view, 4> kNames{
      "within-items", "between-participants", "within-lists", "none"};
  return kNames.at(static_cast<std::size_t>(randomisation));
}

ConditionPermutation permute_conditions(std::span<const ComparedTrial> trials,
                                        std::size_t stimuli,
                                        std::size_t responses,
                                        std::int64_t permutations,
                                        Seed seed) {
  const ConditionDealing dealing{trials};
  const Judge judge{trials, stimuli, responses};
  Tally tally;
  judge.count(dealing.observed(), tally);
  Statistics observed;
  judge.judge(tally, observed);
  ConditionPermutation found{.randomisation = dealing.randomisation(),
                             .permutations = permutations,
                             .used = tally.trials[0] + tally.trials[1],
                             .log10_arrangements = dealing.log10_arrangements(),
                             .chi_square = observed.chi_square,
                             .accuracy_difference = observed.accuracy_difference,
                             .difference = observed.differences,
                             .cell_p = std::vector<std::optional<double>>(stimuli * responses),
                             .cell_q = std::vector<std::optional<double>>(stimuli * responses)};
  found.left_out = static_cast<std::int64_t>(trials.size()) - found.used;
  if (found.randomisation == Randomisation::None || permutations == 0) return found;
  const auto exceedances = exceed(dealing, judge, observed, permutations, seed);
  const auto p_of = [&](std::int64_t as_large) {
    return (1.0 + static_cast<double>(as_large)) / (1.0 + static_cast<double>(permutations));
  };
  found.p = p_of(exceedances.chi_square);
  found.accuracy_p = p_of(exceedances.accuracy);
  for (std::size_t cell = 0; cell < stimuli * responses; ++cell) {
    const bool has_response = tally.cells[2 * cell] + tally.cells[2 * cell + 1] > 0;
    if (has_response && is_in_both(tally, cell / responses, responses)) {
      found.cell_p[cell] = p_of(exceedances.cells[cell]);
    }
  }
  found.cell_q = rates_of(found.cell_p);
  return found;
}

}  // namespace bimodal::analysis

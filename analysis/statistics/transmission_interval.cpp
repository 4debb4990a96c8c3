#include "analysis/statistics/transmission_interval.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <thread>
#include <vector>

#include <fmt/format.h>

namespace bimodal::analysis {

namespace {

constexpr std::int64_t kStudies = 200;  ///< simulated for the coverage
constexpr std::int64_t kFewestStudies = 50;
constexpr std::int64_t kMostResponses = 400'000'000;  ///< drawn for the coverage

/// A matrix that is drawn from, and its transmitted information.
struct Truth {
  MatrixSampler sampler;
  double transmitted = 0.0;
};

/// Bits, of proportions in rows that are presented as often as `row_totals` say.
double transmitted_by(const std::vector<double>& proportions,
                      const std::vector<std::int64_t>& row_totals,
                      std::size_t columns) {
  const auto n =
      static_cast<double>(std::accumulate(row_totals.begin(), row_totals.end(), std::int64_t{0}));
  std::vector<double> responses(columns, 0.0);
  for (std::size_t cell = 0; cell < proportions.size(); ++cell) {
    responses[cell % columns] +=
        proportions[cell] * static_cast<double>(row_totals[cell / columns]) / n;
  }
  double bits = 0.0;
  for (std::size_t cell = 0; cell < proportions.size(); ++cell) {
    if (proportions[cell] <= 0.0) continue;
    bits += proportions[cell] * static_cast<double>(row_totals[cell / columns]) / n *
            std::log2(proportions[cell] / responses[cell % columns]);
  }
  return bits;
}

Truth truth_like(const CellCounts& counts,
                 const std::vector<std::int64_t>& row_totals,
                 std::size_t columns) {
  auto proportions = smoothed_proportions(counts, columns);
  const double transmitted = transmitted_by(proportions, row_totals, columns);
  return {.sampler = MatrixSampler{std::move(proportions), row_totals, columns},
          .transmitted = transmitted};
}

/// How often, and for which interval.
struct Drawing {
  std::int64_t draws = kTransmissionDraws;
  double level = 0.95;
};

struct Bootstrapped {
  Interval interval;
  double bias = 0.0;  ///< of the jackknife estimate, in its standard errors
};

/// Absent if responses never vary.
std::optional<Bootstrapped> bootstrap(const Truth& truth,
                                      const JackknifedTransmission& found,
                                      TransmissionOfCounts& transmission,
                                      const Drawing& drawing,
                                      Random& random) {
  std::vector<double> distances;
  CellCounts counts;
  for (std::int64_t draw = 0; draw < drawing.draws; ++draw) {
    truth.sampler.draw(random, counts);
    const auto drawn = transmission.jackknife(counts);
    if (drawn.standard_error <= 0.0) continue;
    distances.push_back((drawn.estimate - truth.transmitted) / drawn.standard_error);
  }
  if (2 * std::ssize(distances) < drawing.draws) return std::nullopt;
  std::ranges::sort(distances);
  const auto order_statistic = [&](double share) {
    const double rank = std::ceil(share * static_cast<double>(distances.size() + 1) - 1e-9);
    const auto place = std::clamp(rank, 1.0, static_cast<double>(distances.size()));
    return distances[static_cast<std::size_t>(place) - 1];
  };
  const double tail = (1.0 - drawing.level) / 2.0;
  const double sum = std::accumulate(distances.begin(), distances.end(), 0.0);
  return Bootstrapped{
      .interval = {found.estimate - order_statistic(1.0 - tail) * found.standard_error,
                   found.estimate - order_statistic(tail) * found.standard_error},
      .bias = sum / static_cast<double>(distances.size())};
}

class Study {
 public:
  Study(const CellCounts& counts, std::vector<std::int64_t> row_totals, std::size_t columns)
      : row_totals_{std::move(row_totals)},
        columns_{columns},
        n_{std::accumulate(row_totals_.begin(), row_totals_.end(), std::int64_t{0})},
        truth_{truth_like(counts, row_totals_, columns)} {}

  [[nodiscard]] const Truth& truth() const { return truth_; }

  [[nodiscard]] TransmissionOfCounts transmission() const {
    return {row_totals_.size(), columns_, n_};
  }

  [[nodiscard]] std::int64_t studies(const Drawing& drawing) const {
    return std::clamp(
        kMostResponses / (drawing.draws * std::max<std::int64_t>(n_, 1)), kFewestStudies, kStudies);
  }

  /// Whether the interval of a matrix drawn from the truth covers it.
  [[nodiscard]] bool covers(const Drawing& drawing, Random& random) const {
    auto transmission = this->transmission();
    CellCounts counts;
    truth_.sampler.draw(random, counts);
    const auto found = transmission.jackknife(counts);
    const auto own = truth_like(counts, row_totals_, columns_);
    const auto made = bootstrap(own, found, transmission, drawing, random);
    return made && made->interval.low <= truth_.transmitted &&
           truth_.transmitted <= made->interval.high;
  }

 private:
  std::vector<std::int64_t> row_totals_;
  std::size_t columns_;
  std::int64_t n_;
  Truth truth_;
};

std::int64_t count_covering(const Study& study, const Drawing& drawing, Seed seed) {
  const auto workers = std::max<std::int64_t>(1, std::thread::hardware_concurrency());
  std::vector<std::int64_t> covering(static_cast<std::size_t>(workers), 0);
  const auto work = [&](std::int64_t worker) {
    for (auto i = worker; i < study.studies(drawing); i += workers) {
      Random random{derive_seed(seed, "coverage", {static_cast<std::uint64_t>(i)})};
      covering[static_cast<std::size_t>(worker)] += study.covers(drawing, random) ? 1 : 0;
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::int64_t worker = 1; worker < workers; ++worker) threads.emplace_back(work, worker);
    work(0);
  }
  return std::accumulate(covering.begin(), covering.end(), std::int64_t{0});
}

/// Rows and columns without responses left out; absent if there are none, or parts of responses.
struct WholeCounts {
  CellCounts counts;
  std::vector<std::int64_t> row_totals;
  std::size_t columns = 0;
};

std::optional<WholeCounts> whole_counts(const ConfusionMatrix& matrix) {
  WholeCounts whole{.counts = {}, .row_totals = {}, .columns = matrix.responses().size()};
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    const double total = matrix.row_total(i);
    if (total <= 0.0) continue;
    whole.row_totals.push_back(std::llround(total));
    for (std::size_t j = 0; j < whole.columns; ++j) {
      const double count = matrix.count(i, j);
      if (std::trunc(count) != count) return std::nullopt;
      whole.counts.push_back(static_cast<std::int32_t>(count));
    }
  }
  if (whole.counts.empty()) return std::nullopt;
  return whole;
}

}  // namespace

TransmissionOfCounts::TransmissionOfCounts(std::size_t rows,
                                           std::size_t columns,
                                           std::int64_t most_responses)
    : columns_{columns}, row_totals_(rows), column_totals_(columns) {
  k_log_k_.reserve(static_cast<std::size_t>(most_responses) + 1);
  k_log_k_.push_back(0.0);
  for (std::int64_t k = 1; k <= most_responses; ++k) {
    k_log_k_.push_back(static_cast<double>(k) * std::log2(static_cast<double>(k)));
  }
}

void TransmissionOfCounts::add_up(const CellCounts& counts) {
  assert(counts.size() == row_totals_.size() * columns_);
  std::ranges::fill(row_totals_, 0);
  std::ranges::fill(column_totals_, 0);
  sum_ = 0.0;
  for (std::size_t i = 0; i < row_totals_.size(); ++i) {
    for (std::size_t j = 0; j < columns_; ++j) {
      const auto count = counts[i * columns_ + j];
      row_totals_[i] += count;
      column_totals_[j] += count;
      sum_ += k_log_k_[static_cast<std::size_t>(count)];
    }
  }
  n_ = 0;
  for (const auto total : row_totals_) {
    n_ += total;
    sum_ -= k_log_k_[static_cast<std::size_t>(total)];
  }
  for (const auto total : column_totals_) sum_ -= k_log_k_[static_cast<std::size_t>(total)];
}

double TransmissionOfCounts::observed(const CellCounts& counts) {
  add_up(counts);
  const auto n = static_cast<double>(n_);
  return n_ == 0 ? 0.0 : std::log2(n) + sum_ / n;
}

JackknifedTransmission TransmissionOfCounts::jackknife(const CellCounts& counts) {
  JackknifedTransmission found{.observed = observed(counts)};
  if (n_ < 2) return found;
  const auto n = static_cast<double>(n_);
  const auto less_one = [&](std::int32_t k) {
    const auto place = static_cast<std::size_t>(k);
    return k_log_k_[place - 1] - k_log_k_[place];
  };
  double mean = 0.0;
  double squares = 0.0;
  const double base = std::log2(n - 1.0);
  for (std::size_t i = 0; i < row_totals_.size(); ++i) {
    for (std::size_t j = 0; j < columns_; ++j) {
      const auto count = counts[i * columns_ + j];
      if (count == 0) continue;
      const double sum =
          sum_ + less_one(count) - less_one(row_totals_[i]) - less_one(column_totals_[j]);
      const double without = base + sum / (n - 1.0) - found.observed;  // small: no digits are lost
      mean += count * without;
      squares += count * without * without;
    }
  }
  mean /= n;
  found.estimate = found.observed - (n - 1.0) * mean;
  found.standard_error = std::sqrt((n - 1.0) / n * std::max(0.0, squares - n * mean * mean));
  return found;
}

std::optional<JackknifedTransmission> jackknifed_transmission(const ConfusionMatrix& matrix) {
  const auto whole = whole_counts(matrix);
  if (!whole) return std::nullopt;
  return TransmissionOfCounts{
      whole->row_totals.size(),
      whole->columns,
      std::accumulate(whole->row_totals.begin(), whole->row_totals.end(), std::int64_t{0})}
      .jackknife(whole->counts);
}

std::optional<TransmissionInterval> transmission_interval(const ConfusionMatrix& matrix,
                                                          Seed seed,
                                                          std::int64_t draws,
                                                          double level) {
  const Drawing drawing{.draws = draws, .level = level};
  const auto whole = whole_counts(matrix);
  if (!whole) return std::nullopt;
  const Study study{whole->counts, whole->row_totals, whole->columns};
  auto transmission = study.transmission();
  const auto jackknifed = transmission.jackknife(whole->counts);
  TransmissionInterval found{.estimate = jackknifed.estimate};
  Random random{derive_seed(seed, "transmission")};
  const auto made = bootstrap(study.truth(), jackknifed, transmission, drawing, random);
  if (!made) {
    found.why_none = "responses vary too little for an interval";
    return found;
  }
  found.simulated = study.studies(drawing);
  found.measured_coverage = static_cast<double>(count_covering(study, drawing, seed)) /
                            static_cast<double>(found.simulated);
  if (std::abs(made->bias) > kMostBias) {
    found.why_none = fmt::format(
        "of so few responses even the jackknife estimate is off by about {:.1f} standard errors",
        std::abs(made->bias));
  } else if (found.measured_coverage >= kLeastCoverage) {
    found.interval =
        Interval{std::max(0.0, made->interval.low), std::max(0.0, made->interval.high)};
  } else {
    found.why_none = fmt::format(
        "at these counts intervals of {:.0f} % covered the truth in {:.1f} % of {} simulated "
        "studies only",
        100.0 * level,
        100.0 * found.measured_coverage,
        found.simulated);
  }
  return found;
}

}  // namespace bimodal::analysis

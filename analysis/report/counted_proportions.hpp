#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/data/counts_file.hpp"
#include "analysis/statistics/discrimination.hpp"
#include "analysis/statistics/interval.hpp"

namespace bimodal::analysis {

/// Proportions of somebody's counts with every kind of interval for independent trials, and what
/// they mean as sensitivity.
struct CountedProportions {
  CountsTable counts;
  double level = 0.95;
  /// Of a choice among so many, for d'; absent: no choice.
  std::optional<int> alternatives;
  std::vector<std::vector<std::optional<Interval>>> intervals;  ///< of rows, by kIntervalMethods
  std::vector<std::optional<double>> sensitivities;             ///< d' of rows, log-linear
};

[[nodiscard]] CountedProportions estimate_counts(CountsTable counts,
                                                 double level,
                                                 std::optional<int> alternatives);

[[nodiscard]] std::string counted_proportions_text(const CountedProportions& table);
[[nodiscard]] std::string counted_proportions_csv(const CountedProportions& table);
[[nodiscard]] std::string counted_proportions_json(const CountedProportions& table);

/// d' and c of yes-no answers.
[[nodiscard]] std::string yes_no_text(const YesTable& table);
[[nodiscard]] std::string yes_no_csv(const YesTable& table);
[[nodiscard]] std::string yes_no_json(const YesTable& table);

}  // namespace bimodal::analysis

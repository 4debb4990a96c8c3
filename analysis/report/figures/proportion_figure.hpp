#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/report/figures/svg.hpp"
#include "analysis/statistics/interval.hpp"

namespace bimodal::analysis {

/// One participant's share, as a dot.
struct ParticipantDot {
  std::string participant;
  double proportion = 0.0;
};

/// A condition's proportion, as a bar.
struct ProportionBar {
  std::string condition;
  std::optional<double> proportion;  ///< absent: nothing to judge
  std::optional<Interval> interval;
  std::string note;  ///< below the number: "828 trials"
  std::vector<ParticipantDot> dots;
};

/// A bar with its interval for every condition, a dot for every participant below it, and the
/// numbers at the right. `caption` names the axis: "proportion of words correct".
[[nodiscard]] std::string proportion_figure(std::span<const ProportionBar> bars,
                                            const std::string& caption,
                                            PaperWidth width);

}  // namespace bimodal::analysis

#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/report/figures/svg.hpp"

namespace bimodal::analysis {

/// One participant's proportions correct.
struct BenefitPoint {
  std::string participant;
  double auditory = 0.0;  ///< heard alone
  double bimodal = 0.0;   ///< heard and seen
};

/// Of one bimodal condition.
struct BenefitSeries {
  std::string condition;
  std::vector<BenefitPoint> points;
};

/// What seeing the talker adds, AV - A, against A: a mark for each participant in each bimodal
/// condition, and the largest possible benefit, 1 - A, as a line. `auditory` names condition A.
[[nodiscard]] std::string benefit_figure(std::span<const BenefitSeries> series,
                                         const std::string& auditory,
                                         PaperWidth width);

}  // namespace bimodal::analysis

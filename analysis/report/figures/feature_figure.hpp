#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/report/figures/svg.hpp"

namespace bimodal::analysis {

/// The part of a feature's information that came through, T / H.
struct FeatureShare {
  std::string feature;
  std::optional<double> observed;      ///< absent: the feature has one value only, or no responses
  std::optional<double> miller_madow;  ///< corrected; may be below 0 or above 1
};

/// Of one condition; all conditions of a figure have the same features in the same order.
struct FeatureProfile {
  std::string condition;
  std::vector<FeatureShare> shares;
};

/// For every feature a bar a condition: filled as corrected by Miller and Madow's formula, outlined
/// as observed; both numbers at the right. Few conditions (at most seven have colours of their
/// own).
[[nodiscard]] std::string feature_figure(std::span<const FeatureProfile> profiles,
                                         PaperWidth width);

}  // namespace bimodal::analysis

#pragma once

#include <optional>
#include <span>
#include <vector>

namespace bimodal::analysis {

/// Pearson's product-moment correlation of pairs; absent of fewer than two, or if either side has
/// no spread.
[[nodiscard]] std::optional<double> pearson(std::span<const double> xs, std::span<const double> ys);

/// Ranks from 1; equal values share the mean of theirs.
[[nodiscard]] std::vector<double> ranks(std::span<const double> values);

/// Spearman's rank correlation: Pearson's of the ranks.
[[nodiscard]] std::optional<double> spearman(std::span<const double> xs,
                                             std::span<const double> ys);

/// What the correlation of two halves would be at twice the length: 2r / (1 + r) (Spearman, 1910,
/// Br. J. Psychol. 3, 271-295; Brown, 1910, ibid., 296-322). r > -1.
[[nodiscard]] double spearman_brown(double r);

/// Benjamini & Hochberg's (1995, J. R. Stat. Soc. B 57, 289-300) adjusted p-values, in the order of
/// the p-values: those at most q are significant at a false discovery rate of q.
[[nodiscard]] std::vector<double> false_discovery_rates(std::span<const double> p_values);

}  // namespace bimodal::analysis

#pragma once

#include <span>
#include <string>

#include "analysis/report/results.hpp"

namespace bimodal::analysis {

/// All figures are SVG elements for use within HTML: text as text, no script, nothing fetched;
/// sizes in CSS pixels, never wider than the page.

/// Proportion of correct words in each condition: the pooled value with its interval, and a dot for
/// every participant.
[[nodiscard]] std::string figure_of_words(const Results& results);

/// A confusion matrix: rows are stimuli and columns responses, both by place of articulation; row
/// proportions in one hue on the fixed scale 0-1, printed where above .005; row n at the right.
[[nodiscard]] std::string figure_of_confusions(const UnitConfusions& confusions);

/// The scale of every confusion matrix.
[[nodiscard]] std::string figure_of_scale();

}  // namespace bimodal::analysis

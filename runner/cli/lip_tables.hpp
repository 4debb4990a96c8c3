#pragma once

#include <span>
#include <string>

#include "runner/cli/lip_comparison.hpp"

namespace bimodal::runner {

/// Prints how clips compare: r and RMSE per clip and over clips, the timing of closures and of
/// rounding, and inner_h and outer_w at the centres of phones.
void print_comparison(std::span<const ClipComparison> clips);

/// The same and the other measures' phones, as a table with the columns
/// clip,phone,measure,quantity,n,value: one number a line. Empty where a column has no meaning.
[[nodiscard]] std::string comparison_csv(std::span<const ClipComparison> clips);

}  // namespace bimodal::runner

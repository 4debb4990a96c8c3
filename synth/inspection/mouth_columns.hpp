#pragma once

#include <span>
#include <string_view>

#include "synth/inspection/mouth_measures.hpp"

namespace bimodal::synth {

/// One measure of the mouth as a column of tables and an axis of plots.
struct MouthColumn {
  std::string_view name;  ///< with its unit: "inner_height_mm"
  std::string_view meaning;
  double (*of)(const MouthMeasures& measures);
};

/// Every measure, in the order of tables.
[[nodiscard]] std::span<const MouthColumn> mouth_columns();

}  // namespace bimodal::synth

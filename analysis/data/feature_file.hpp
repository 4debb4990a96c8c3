#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// What sounds are like: for every label the value of each feature ("voiced", "labial"). A value
/// that is empty says that the feature does not apply to that label.
struct FeatureTable {
  std::vector<std::string> features;                       ///< their names
  std::map<std::string, std::vector<std::string>> values;  ///< of a label, in the features' order

  /// One value for each label; empty where the label is not in the table.
  [[nodiscard]] std::vector<std::string> values_of(const std::vector<std::string>& labels,
                                                   std::size_t feature) const;
};

/// Throws Error if a stimulus that was presented has no values.
void require_stimuli(const ConfusionMatrix& matrix, const FeatureTable& features);

/// Features as CSV: the first line has their names, from its second field on; each line after it a
/// label and its values. Values are text. Throws Error, naming file and line.
[[nodiscard]] FeatureTable parse_features(std::string_view text, std::string_view file);

/// The same of a file.
[[nodiscard]] FeatureTable read_features(const std::filesystem::path& file);

}  // namespace bimodal::analysis

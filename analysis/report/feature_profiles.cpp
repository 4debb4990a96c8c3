#include "analysis/report/feature_profiles.hpp"

#include "analysis/scoring/phone_features.hpp"

namespace bimodal::analysis {

FeatureTable consonant_feature_table() {
  FeatureTable table{.features = {"voicing", "place", "manner"}, .values = {}};
  for (const Phone phone : all_phones()) {
    if (!is_consonant(phone)) continue;
    const auto& features = consonant_features(phone);
    table.values[std::string{symbol(phone)}] = {features.voiced ? "voiced" : "voiceless",
                                                std::string{name(features.place)},
                                                std::string{name(features.manner)}};
  }
  return table;
}

std::vector<FeatureProfileTable> tabulate_features(std::span<const UnitConfusions> confusions) {
  const auto features = consonant_feature_table();
  std::vector<FeatureProfileTable> tables;
  for (const auto& table : confusions) {
    if (table.unit == Unit::Vowel || table.matrix.total() <= 0.0) continue;
    tables.push_back({.unit = table.unit,
                      .condition = table.condition,
                      .information = tabulate_information(
                          std::string{title(table.unit)}, table.matrix, features)});
  }
  return tables;
}

}  // namespace bimodal::analysis

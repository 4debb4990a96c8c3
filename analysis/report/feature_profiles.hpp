#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/data/feature_file.hpp"
#include "analysis/report/confusions.hpp"
#include "analysis/report/information_table.hpp"

namespace bimodal::analysis {

/// Voicing, place and manner of every consonant by its ARPAbet symbol (consonant_features).
[[nodiscard]] FeatureTable consonant_feature_table();

/// How much of each feature of the consonants came through in one condition.
struct FeatureProfileTable {
  Unit unit = Unit::ConsonantInitial;
  std::string condition;
  InformationTable information;  ///< without intervals: responses of one participant are alike
};

/// Of every matrix of initial and final consonants that has responses. Responses that are no
/// consonant (deleted, blank, other) are left out of the features and counted there.
[[nodiscard]] std::vector<FeatureProfileTable> tabulate_features(
    std::span<const UnitConfusions> confusions);

}  // namespace bimodal::analysis

#pragma once

#include <string>

#include "analysis/data/feature_file.hpp"
#include "analysis/statistics/sinfa.hpp"

namespace bimodal::analysis {

/// Throws Error if a stimulus that was presented is not in the table of features.
[[nodiscard]] Sinfa analyse_sequentially(const ConfusionMatrix& matrix,
                                         const FeatureTable& features);

/// For people: the rounds in their order.
[[nodiscard]] std::string sinfa_text(const std::string& title, const Sinfa& sinfa);

/// Every figure in full precision: a line for each candidate of each round.
[[nodiscard]] std::string sinfa_csv(const Sinfa& sinfa);

/// The same as JSON.
[[nodiscard]] std::string sinfa_json(const std::string& title, const Sinfa& sinfa);

}  // namespace bimodal::analysis

#pragma once

#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "analysis/report/benefits.hpp"

namespace bimodal::analysis {

/// What faces add to voices, for people; nothing where there is no such condition.
[[nodiscard]] std::string benefit_text(std::span<const BenefitRow> rows,
                                       std::span<const ShareRow> shares);

/// Every figure in full precision: a list for each of the two.
[[nodiscard]] nlohmann::ordered_json benefit_json(std::span<const BenefitRow> rows);
[[nodiscard]] nlohmann::ordered_json share_json(std::span<const ShareRow> shares);

}  // namespace bimodal::analysis

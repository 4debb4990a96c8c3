#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/report/proportions.hpp"

namespace bimodal::analysis {

/// Proportions correct of conditions, pooled and of participants.
struct ProportionTable {
  std::vector<Proportion> rows;
  /// Of a choice among so many, for d' of words; absent: open answers, which have none.
  std::optional<int> alternatives;
};

[[nodiscard]] std::string proportion_text(const ProportionTable& table);
[[nodiscard]] std::string proportion_csv(const ProportionTable& table);
[[nodiscard]] nlohmann::ordered_json proportion_json(const ProportionTable& table);

}  // namespace bimodal::analysis

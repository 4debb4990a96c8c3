#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include <nlohmann/json.hpp>

#include "analysis/statistics/interval.hpp"

namespace bimodal::analysis {

/// A count as JSON: without decimal point where it is whole.
[[nodiscard]] inline nlohmann::ordered_json json_count(double count) {
  if (std::trunc(count) == count) return static_cast<std::int64_t>(count);
  return count;
}

/// Null where there is none.
template <typename Value>
[[nodiscard]] nlohmann::ordered_json optional_json(const std::optional<Value>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

/// Both ends; null where there is none.
[[nodiscard]] inline nlohmann::ordered_json interval_json(const std::optional<Interval>& interval) {
  if (!interval) return {};
  return nlohmann::ordered_json::array({interval->low, interval->high});
}

}  // namespace bimodal::analysis

#pragma once

#include <cmath>
#include <cstdint>

#include <nlohmann/json.hpp>

namespace bimodal::analysis {

/// A count as JSON: without decimal point where it is whole.
[[nodiscard]] inline nlohmann::ordered_json json_count(double count) {
  if (std::trunc(count) == count) return static_cast<std::int64_t>(count);
  return count;
}

}  // namespace bimodal::analysis

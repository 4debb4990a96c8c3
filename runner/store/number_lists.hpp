#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// "[1,2,3]": arrays that SQLite's json_each, R and Python all read.
[[nodiscard]] std::string as_json(std::span<const std::int64_t> numbers);

/// Nanoseconds since `origin`, which keeps the numbers short.
[[nodiscard]] std::string as_json(std::span<const Duration> instants, Duration origin);

/// The way back. Throws StoreError for anything else than an array of whole numbers.
[[nodiscard]] std::vector<std::int64_t> numbers_from(const std::string& json);
[[nodiscard]] std::vector<Duration> instants_from(const std::string& json, Duration origin);

}  // namespace bimodal::runner

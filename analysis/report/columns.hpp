#pragma once

#include <span>
#include <string_view>

namespace bimodal::analysis {

/// The data dictionary: what every column of every CSV table means.
struct Column {
  std::string_view table;  ///< "trials"
  std::string_view name;
  std::string_view meaning;
};

/// Tables together, columns in their order.
[[nodiscard]] std::span<const Column> all_columns();

[[nodiscard]] std::span<const Column> columns_of(std::string_view table);

}  // namespace bimodal::analysis

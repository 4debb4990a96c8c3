#pragma once

#include <string_view>

#include "analysis/data/matrix_file.hpp"

namespace bimodal::analysis {

/// One reader for each form in which a matrix may come; see parse_titled_matrix. All throw Error,
/// naming file and line.

/// CSV, as a table or as a list.
[[nodiscard]] TitledMatrix parse_csv_matrix(std::string_view text, std::string_view file);

[[nodiscard]] TitledMatrix parse_json_matrix(std::string_view text, std::string_view file);

/// `text` is decoded.
[[nodiscard]] TitledMatrix parse_praat_matrix(std::string_view text, std::string_view file);

}  // namespace bimodal::analysis

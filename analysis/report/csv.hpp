#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace bimodal::analysis {

/// One field of a CSV table: absent, text, a count or a real number.
using CsvField = std::variant<std::monostate, std::string_view, std::int64_t, double>;

/// Appends one line (RFC 4180, but ended by a line feed alone). Text is always in quotation marks,
/// numbers never are, and have a decimal point; an absent value is an empty field. R and pandas
/// take the answer "NA" for a missing value all the same, unless told na.strings = character() or
/// keep_default_na = False.
void append_csv(std::string& table, std::span<const CsvField> fields);

/// Absent where there is none.
[[nodiscard]] CsvField csv_number(const std::optional<double>& value);

}  // namespace bimodal::analysis

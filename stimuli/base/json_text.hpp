#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

#include <nlohmann/json.hpp>

namespace bimodal {

/// What a JSON file may cost: it may come from anywhere.
inline constexpr std::size_t kLargestFile = 16UL << 20U;  ///< bytes
inline constexpr std::size_t kDeepestNesting = 64;        ///< objects and arrays in each other
inline constexpr std::size_t kMostValues = 200'000;       ///< in one file

/// Why a text is not JSON that we take.
struct TextFault {
  std::size_t line = 0;  ///< from 1; 0 where a line has no meaning
  std::string finding;
  std::string remedy;
};

/// Parses an untrusted text: at most kLargestFile bytes of UTF-8 without NUL, RFC 8259 JSON, nested
/// at most kDeepestNesting deep, at most `most_values` values, every number within the range of a
/// double.
[[nodiscard]] std::variant<nlohmann::json, TextFault> parse_json(
    std::string_view text, std::size_t most_values = kMostValues);

/// A value as JSON for a message, shortened to about 60 bytes, without line breaks.
[[nodiscard]] std::string shown(const nlohmann::json& value);

}  // namespace bimodal

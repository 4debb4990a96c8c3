#pragma once

#include <charconv>
#include <cstdint>
#include <limits>
#include <string>

#include <fmt/format.h>

namespace bimodal {

/// A check for options of a command line: what is wrong with `text` as a whole number from `lowest`
/// to `highest`; empty if nothing is.
template <typename Number>
[[nodiscard]] std::string whole_number_fault(const std::string& text,
                                             Number lowest,
                                             Number highest = std::numeric_limits<Number>::max()) {
  Number number{};
  const auto* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc{} && stop == end && number >= lowest && number <= highest) return {};
  return highest == std::numeric_limits<Number>::max()
             ? fmt::format("'{}' is not a whole number from {}", text, lowest)
             : fmt::format("'{}' is not a whole number from {} to {}", text, lowest, highest);
}

}  // namespace bimodal

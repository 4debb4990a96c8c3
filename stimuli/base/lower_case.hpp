#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace bimodal {

/// The text with a to z for A to Z, whatever the locale; all other bytes stay.
[[nodiscard]] inline std::string lower_case(std::string_view text) {
  std::string lower{text};
  std::ranges::transform(lower, lower.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return lower;
}

}  // namespace bimodal

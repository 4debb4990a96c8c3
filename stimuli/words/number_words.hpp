#pragma once

#include <string_view>
#include <vector>

namespace bimodal {

/// How a number is said, in American English: "22" twenty two, "1990" one thousand nine hundred
/// ninety, "3.5" three point five. Numbers beyond 999,999 and those that begin with a zero are said
/// digit by digit ("007" zero zero seven). Precondition: digits, and at most one point between
/// digits.
[[nodiscard]] std::vector<std::string_view> number_words(std::string_view number);

}  // namespace bimodal

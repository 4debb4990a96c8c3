#include "analysis/cli/command_line.hpp"

#include <algorithm>

namespace bimodal::analysis {

namespace {

bool is_plain(char letter) {
  constexpr std::string_view kSigns = "_./=:@%+,-";
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || kSigns.find(letter) != std::string_view::npos;
}

std::string quoted(const std::string& word) {
  if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
  std::string text = "'";
  for (const char letter : word) {
    if (letter == '\'') {
      text += R"('\'')";
    } else {
      text += letter;
    }
  }
  return text + "'";
}

}  // namespace

std::string command_line(std::string_view program, std::span<const std::string> arguments) {
  std::string line{program};
  for (const auto& argument : arguments) line += " " + quoted(argument);
  return line;
}

}  // namespace bimodal::analysis

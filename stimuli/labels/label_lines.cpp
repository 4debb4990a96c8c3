#include "stimuli/labels/label_lines.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "stimuli/base/diagnostic.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal {

namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

}  // namespace

void refuse(const LabelLine& line, std::string_view finding, std::string_view remedy) {
  throw Error{describe(Diagnostic{.file = std::string{line.file},
                                  .line = line.number,
                                  .finding = std::string{finding},
                                  .remedy = std::string{remedy}})};
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

bool is_plain_text(std::string_view text) {
  return is_utf8(text) && text.find_first_of(std::string_view{"\0\r", 2}) == std::string_view::npos;
}

std::string_view take_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  const auto word = text.substr(0, text.find_first_of(kBlanks));
  text.remove_prefix(word.size());
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return word;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  const auto continues_character = [&](std::size_t at) {
    return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
  };
  std::size_t end = std::min(kLongest, text.size());
  while (end > 0 && end < text.size() && continues_character(end)) --end;
  std::string shown{text.substr(0, end)};
  const auto is_control = [](unsigned char letter) { return letter < 0x20U || letter == 0x7FU; };
  std::ranges::replace_if(shown, is_control, ' ');
  return fmt::format("\"{}{}\"", shown, end < text.size() ? "..." : "");
}

std::optional<std::string_view> LineReader::next() {
  if (rest_.empty()) return std::nullopt;
  const auto line = rest_.substr(0, rest_.find('\n'));
  rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
  ++number_;
  return line;
}

}  // namespace bimodal

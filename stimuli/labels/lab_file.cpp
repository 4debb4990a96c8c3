#include "stimuli/labels/lab_file.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>

#include <fmt/format.h>

#include "stimuli/labels/label_time.hpp"
#include "stimuli/labels/tier_builder.hpp"

namespace bimodal {

namespace {

constexpr Duration kHtkUnit{100};
constexpr std::string_view kHtkUnitName = "100 ns";
constexpr std::string_view kHtkRemedy =
    "write start, end (both in 100 ns) and label, or give a file with times";

bool is_whole_number(std::string_view word) {
  long number = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return !word.empty() && error == std::errc{} && stop == word.data() + word.size();
}

bool is_octal(std::string_view digits) {
  return digits.size() == 3 && digits.front() <= '3' &&
         std::ranges::all_of(digits, [](char digit) { return digit >= '0' && digit <= '7'; });
}

/// The character of the escape behind a backslash, which is taken off the text.
char take_escaped(std::string_view& text) {
  if (const auto digits = text.substr(0, 3); is_octal(digits)) {
    text.remove_prefix(3);
    return static_cast<char>((digits[0] - '0') * 64 + (digits[1] - '0') * 8 + (digits[2] - '0'));
  }
  const char letter = text.front();
  text.remove_prefix(1);
  return letter;
}

/// HTK's strings: up to a blank, or within quotation marks of either kind; a backslash escapes a
/// character or precedes its three octal digits. A mark that is not closed is a letter.
std::string take_htk_string(std::string_view& text) {
  const char quote = text.starts_with('"') || text.starts_with('\'') ? text.front() : '\0';
  std::string value;
  auto rest = text;
  if (quote != '\0') rest.remove_prefix(1);
  while (!rest.empty()) {
    const char letter = rest.front();
    if (letter == quote && quote != '\0') {
      text = rest.substr(1);
      return value;
    }
    if (quote == '\0' && (letter == ' ' || letter == '\t')) break;
    rest.remove_prefix(1);
    value += letter == '\\' && !rest.empty() ? take_escaped(rest) : letter;
  }
  if (quote != '\0') return std::string{take_word(text)};
  text = rest;
  return value;
}

Label htk_label(std::string_view line, const LabelLine& place) {
  const auto start = take_word(line);
  const auto end = take_word(line);
  if (start == "///") {
    refuse(place, "\"///\" begins a second transcription", "keep one of them");
  }
  if (end.empty() || !std::isdigit(static_cast<unsigned char>(end.front()))) {
    refuse(place, fmt::format("{} has no start and end", in_quotes(start)), kHtkRemedy);
  }
  if (line.empty()) refuse(place, "there is no label behind the times", kHtkRemedy);
  if (start.find('.') != std::string_view::npos) {
    refuse(place,
           fmt::format("{} is not a time in units of {}", in_quotes(start), kHtkUnitName),
           "write a whole number, or if this is Festival's file, a line \"#\" behind its heading");
  }
  Label label;
  label.start = time_from_units(start, kHtkUnit, kHtkUnitName, place);
  label.end = time_from_units(end, kHtkUnit, kHtkUnitName, place);
  label.text = take_htk_string(line);
  if (!is_plain_text(label.text)) {
    refuse(place, "the escapes of the label make no text in UTF-8", "write its letters themselves");
  }
  return label;
}

Labels finished(TierBuilder builder, std::string_view file) {
  auto labels = std::move(builder).finish();
  if (labels.tiers.front().labels.empty()) {
    refuse({file}, "there is no label in it", "is this the right file?");
  }
  labels.tiers.front().name = name_by_content(labels.tiers.front());
  return labels;
}

Labels parse_htk(std::string_view text, std::string_view file) {
  TierBuilder builder{file};
  const auto tier = builder.add_tier({});
  LineReader lines{text};
  while (const auto line = lines.next()) {
    if (line->starts_with("#!MLF!#")) {
      refuse({file, lines.number()}, "this is a master label file", "give its parts one by one");
    }
    const auto content = trimmed(*line);
    if (content.empty()) continue;
    builder.add(tier, htk_label(content, {file, lines.number()}), lines.number());
  }
  return finished(std::move(builder), file);
}

Label xwaves_label(std::string_view line,
                   Duration start,
                   std::string_view separator,
                   const LabelLine& place) {
  const auto end = take_word(line);
  const auto colour = take_word(line);
  Label label;
  label.start = start;
  label.end = time_from_seconds(end, place);
  if (!is_whole_number(colour) || line.empty()) {
    refuse(place,
           fmt::format("{} is not followed by a colour and a label", in_quotes(end)),
           "write the end in seconds, a number for the colour and the label");
  }
  label.text = trimmed(line.substr(0, line.find(separator)));
  return label;
}

Labels parse_xwaves(std::string_view text, std::string_view file) {
  LineReader lines{text};
  std::string_view separator = ";";
  for (auto line = lines.next(); line && trimmed(*line) != "#"; line = lines.next()) {
    auto words = *line;
    if (take_word(words) == "separator" && !words.empty()) separator = trimmed(words);
  }
  TierBuilder builder{file};
  const auto tier = builder.add_tier({});
  Duration start{};
  while (const auto line = lines.next()) {
    const auto content = trimmed(*line);
    if (content.empty()) continue;
    const LabelLine place{file, lines.number()};
    auto label = xwaves_label(content, start, separator, place);
    if (label.end < start && start - label.end <= kRounding) label.end = start;
    start = label.end;
    builder.add(tier, std::move(label), lines.number());
  }
  return finished(std::move(builder), file);
}

bool has_xwaves_heading(std::string_view text) {
  LineReader lines{text};
  while (const auto line = lines.next()) {
    if (trimmed(*line) == "#") return true;
  }
  return false;
}

std::string htk_string(std::string_view text) {
  const bool plain = std::ranges::none_of(text, [](char letter) {
    return (letter >= '\0' && letter <= ' ') || letter == '"' || letter == '\'' || letter == '\\';
  });
  if (plain && !text.empty()) return std::string{text};
  std::string string = "\"";
  for (const char letter : text) {
    if (letter >= '\0' && letter < ' ') {
      string += fmt::format("\\{:03o}", static_cast<unsigned>(letter));
    } else {
      if (letter == '"' || letter == '\\') string += '\\';
      string += letter;
    }
  }
  return string + '"';
}

}  // namespace

Labels parse_lab(std::string_view text, std::string_view file) {
  return has_xwaves_heading(text) ? parse_xwaves(text, file) : parse_htk(text, file);
}

std::string htk_lab(const Tier& tier) {
  std::string text;
  for (const auto& label : tier.labels) {
    if (label.text.empty() && label.start < label.end) continue;
    fmt::format_to(std::back_inserter(text),
                   "{} {} {}\n",
                   units_text(label.start, kHtkUnit),
                   units_text(label.end, kHtkUnit),
                   htk_string(label.text));
  }
  return text;
}

}  // namespace bimodal

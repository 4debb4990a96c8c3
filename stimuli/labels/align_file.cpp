#include "stimuli/labels/align_file.hpp"

#include <iterator>

#include <fmt/format.h>

#include "stimuli/labels/label_time.hpp"
#include "stimuli/labels/tier_builder.hpp"

namespace bimodal {

namespace {

constexpr Duration kUnit = std::chrono::microseconds{40};
constexpr std::string_view kUnitName = "1/25000 s";

Label align_label(std::string_view line, const LabelLine& place) {
  const auto start = take_word(line);
  const auto end = take_word(line);
  if (line.empty()) {
    refuse(place,
           fmt::format("{} is not followed by end and word", in_quotes(start)),
           "write start, end (25000 to the second) and word");
  }
  Label label;
  label.start = time_from_units(start, kUnit, kUnitName, place);
  label.end = time_from_units(end, kUnit, kUnitName, place);
  label.text = line;
  return label;
}

}  // namespace

Labels parse_align(std::string_view text, std::string_view file) {
  TierBuilder builder{file};
  const auto tier = builder.add_tier("words");
  LineReader lines{text};
  while (const auto line = lines.next()) {
    const auto content = trimmed(*line);
    if (content.empty()) continue;
    const LabelLine place{file, lines.number()};
    builder.add(tier, align_label(content, place), place.number);
  }
  auto labels = std::move(builder).finish();
  if (labels.tiers.front().labels.empty()) {
    refuse({file}, "there is no label in it", "is this the right file?");
  }
  return labels;
}

std::string align_text(const Tier& tier) {
  std::string text;
  for (const auto& label : tier.labels) {
    fmt::format_to(std::back_inserter(text),
                   "{} {} {}\n",
                   units_text(label.start, kUnit),
                   units_text(label.end, kUnit),
                   label.text);
  }
  return text;
}

}  // namespace bimodal

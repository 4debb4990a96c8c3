#include "stimuli/labels/text_grid.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "stimuli/labels/label_time.hpp"
#include "stimuli/labels/praat_text.hpp"
#include "stimuli/labels/tier_builder.hpp"

namespace bimodal {

namespace {

constexpr std::string_view kSaveAsText = "in Praat, choose 'Save as text file...'";

/// Reads up to the class of the object.
void read_heading(PraatText& praat) {
  const auto type = praat.take_string("\"ooTextFile\"");
  if (type.starts_with("Praat chronological")) {
    refuse(praat.line(), "this is a chronological TextGrid", kSaveAsText);
  }
  if (type != "ooTextFile" && type != "ooTextFile short") {
    refuse(praat.line(), fmt::format("{} is not \"ooTextFile\"", in_quotes(type)), kSaveAsText);
  }
  const auto object = praat.take_string("\"TextGrid\"");
  if (object != "TextGrid") {
    refuse(praat.line(),
           fmt::format("this is a Praat {}, not a TextGrid", object),
           "in Praat, choose the TextGrid alone, then 'Save as text file...'");
  }
}

/// One tier of a grid that ends at `end`.
void read_tier(PraatText& praat, Duration end, TierBuilder& builder) {
  const auto kind = praat.take_string("the class of a tier");
  if (kind != "IntervalTier" && kind != "TextTier") {
    refuse(praat.line(),
           fmt::format("{} is not the class of a tier", in_quotes(kind)),
           "write \"IntervalTier\" or \"TextTier\"");
  }
  const auto tier = builder.add_tier(praat.take_string("the name of a tier"));
  (void)praat.take_seconds("the start of a tier");
  (void)praat.take_seconds("the end of a tier");
  const bool points = kind == "TextTier";
  const auto count = praat.take_count(points ? "the number of points" : "the number of intervals");
  for (std::size_t i = 0; i < count; ++i) {
    Label label;
    label.start = praat.take_seconds(points ? "the time of a point" : "the start of an interval");
    label.end = points ? label.start : praat.take_seconds("the end of an interval");
    const auto line = praat.line();
    if (label.end > end + kRounding) {
      refuse(line,
             fmt::format("the label ends at {} s, beyond the end of the TextGrid, {} s",
                         seconds_text(label.end),
                         seconds_text(end)),
             "mend its time or the xmax above");
    }
    label.end = std::min(label.end, end);
    label.start = std::min(label.start, end);
    label.text = praat.take_string("the text of a label");
    builder.add(tier, std::move(label), line.number);
  }
}

bool is_point(const Label& label) {
  return label.start == label.end;
}

bool is_gap(const Label& label) {
  return label.text.empty() && !is_point(label);
}

/// The labels and between them empty ones, from 0 to the end.
std::vector<Label> filled(const Tier& tier, Duration end) {
  std::vector<Label> intervals;
  Duration reached{};
  const auto fill = [&](Duration until) {
    if (reached < until) intervals.push_back({.start = reached, .end = until, .text = {}});
  };
  for (const auto& label : tier.labels) {
    if (is_gap(label)) continue;
    fill(label.start);
    intervals.push_back(label);
    reached = label.end;
  }
  fill(end);
  return intervals;
}

std::string doubled_quotes(std::string_view text) {
  std::string doubled;
  for (const char letter : text) doubled.append(letter == '"' ? 2 : 1, letter);
  return doubled;
}

using Output = std::back_insert_iterator<std::string>;

void write_points(const Tier& tier, Output out) {
  fmt::format_to(out, "        points: size = {}\n", tier.labels.size());
  for (std::size_t i = 0; i < tier.labels.size(); ++i) {
    fmt::format_to(out,
                   "        points [{}]:\n"
                   "            number = {}\n"
                   "            mark = \"{}\"\n",
                   i + 1,
                   seconds_text(tier.labels[i].start),
                   doubled_quotes(tier.labels[i].text));
  }
}

void write_intervals(const Tier& tier, Duration end, Output out) {
  const auto intervals = filled(tier, end);
  fmt::format_to(out, "        intervals: size = {}\n", intervals.size());
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    fmt::format_to(out,
                   "        intervals [{}]:\n"
                   "            xmin = {}\n"
                   "            xmax = {}\n"
                   "            text = \"{}\"\n",
                   i + 1,
                   seconds_text(intervals[i].start),
                   seconds_text(intervals[i].end),
                   doubled_quotes(intervals[i].text));
  }
}

}  // namespace

Labels parse_text_grid(std::string_view text, std::string_view file) {
  PraatText praat{text, file};
  read_heading(praat);
  (void)praat.take_seconds("the start of the TextGrid");
  const auto end = praat.take_seconds("the end of the TextGrid");
  TierBuilder builder{file};
  if (praat.take_flag("<exists>") == "exists") {
    const auto count = praat.take_count("the number of tiers");
    for (std::size_t i = 0; i < count; ++i) read_tier(praat, end, builder);
  }
  if (!praat.at_end()) {
    refuse(praat.line(),
           "there is more behind the last tier",
           "mend the number of tiers or intervals ('size'), or save it again from Praat");
  }
  return std::move(builder).finish(end);
}

std::string text_grid(const Labels& labels) {
  const auto end = seconds_text(labels.end);
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out,
                 "File type = \"ooTextFile\"\n"
                 "Object class = \"TextGrid\"\n\n"
                 "xmin = 0.0\n"
                 "xmax = {}\n"
                 "tiers? <exists>\n"
                 "size = {}\n"
                 "item []:\n",
                 end,
                 labels.tiers.size());
  for (std::size_t i = 0; i < labels.tiers.size(); ++i) {
    const auto& tier = labels.tiers[i];
    const bool points = !tier.labels.empty() && std::ranges::all_of(tier.labels, is_point);
    fmt::format_to(out,
                   "    item [{}]:\n"
                   "        class = \"{}\"\n"
                   "        name = \"{}\"\n"
                   "        xmin = 0.0\n"
                   "        xmax = {}\n",
                   i + 1,
                   points ? "TextTier" : "IntervalTier",
                   doubled_quotes(tier.name),
                   end);
    if (points) {
      write_points(tier, out);
    } else {
      write_intervals(tier, labels.end, out);
    }
  }
  return text;
}

}  // namespace bimodal

#include "stimuli/labels/csv_labels.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "stimuli/base/csv.hpp"
#include "stimuli/base/csv_reader.hpp"
#include "stimuli/labels/label_time.hpp"
#include "stimuli/labels/tier_builder.hpp"

namespace bimodal {

namespace {

struct Columns {
  std::size_t start = 0;
  std::size_t end = 0;
  std::size_t text = 0;
  std::optional<std::size_t> tier;
  std::size_t count = 0;
};

Columns columns_of(const std::vector<std::string>& header, const LabelLine& line) {
  const auto find = [&](std::string_view name) -> std::optional<std::size_t> {
    const auto found =
        std::ranges::find_if(header, [&](const auto& field) { return trimmed(field) == name; });
    if (found == header.end()) return std::nullopt;
    return static_cast<std::size_t>(found - header.begin());
  };
  const auto require = [&](std::string_view name) {
    if (const auto column = find(name)) return *column;
    refuse(line,
           fmt::format("there is no column \"{}\" in {}",
                       name,
                       in_quotes(fmt::format("{}", fmt::join(header, ",")))),
           "begin with the line start_s,end_s,text or tier,start_s,end_s,text (with commas)");
  };
  return {.start = require("start_s"),
          .end = require("end_s"),
          .text = require("text"),
          .tier = find("tier"),
          .count = header.size()};
}

}  // namespace

Labels parse_csv_labels(std::string_view text, std::string_view file) {
  CsvReader csv{text, file, ','};
  const auto here = [&] { return LabelLine{file, csv.line()}; };
  const auto header = csv.next();
  if (!header) refuse({file}, "the file is empty", "begin with the line start_s,end_s,text");
  const auto columns = columns_of(*header, here());
  TierBuilder builder{file};
  std::map<std::string, std::size_t> tiers;
  while (auto fields = csv.next()) {
    if (fields->size() != columns.count) {
      refuse(here(),
             fmt::format("{} fields, but the first line has {}", fields->size(), columns.count),
             "write one for each column, and texts with commas in quotation marks");
    }
    const auto name = columns.tier ? fields->at(*columns.tier) : std::string{};
    auto found = tiers.find(name);
    if (found == tiers.end()) found = tiers.emplace(name, builder.add_tier(name)).first;
    builder.add(found->second,
                {.start = time_from_seconds(trimmed(fields->at(columns.start)), here()),
                 .end = time_from_seconds(trimmed(fields->at(columns.end)), here()),
                 .text = std::move(fields->at(columns.text))},
                csv.line());
  }
  auto labels = std::move(builder).finish();
  if (!columns.tier) {
    for (auto& tier : labels.tiers) tier.name = name_by_content(tier);
  }
  return labels;
}

std::string csv_labels(const Labels& labels) {
  std::string text = "tier,start_s,end_s,text\n";
  const auto write =
      [&](const std::string& tier, Duration start, Duration end, std::string_view said) {
        fmt::format_to(std::back_inserter(text),
                       "{},{},{},{}\n",
                       csv_field(tier),
                       seconds_text(start),
                       seconds_text(end),
                       csv_field(said));
      };
  for (const auto& tier : labels.tiers) {
    for (const auto& label : tier.labels) write(tier.name, label.start, label.end, label.text);
    const Duration reached = tier.labels.empty() ? Duration{} : tier.labels.back().end;
    if (reached < labels.end) write(tier.name, reached, labels.end, {});
  }
  return text;
}

}  // namespace bimodal

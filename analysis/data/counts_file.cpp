#include "analysis/data/counts_file.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "stimuli/base/csv_reader.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal::analysis {

namespace {

constexpr std::array<std::string_view, 4> kYesColumns{"hits", "signals", "false_alarms", "noises"};
constexpr std::string_view kYesForm =
    "begin with a line like condition,hits,signals,false_alarms,noises";
constexpr std::string_view kForm =
    "begin with a line like condition,k,n and let lines like visual,86,414 follow";

std::size_t column_of(const std::vector<std::string>& header,
                      std::string_view name,
                      const CsvReader& csv,
                      std::string_view form) {
  const auto found = std::ranges::find(header, name);
  if (found == header.end()) csv.refuse(fmt::format("there is no column \"{}\"", name), form);
  if (std::ranges::count(header, name) > 1) {
    csv.refuse(fmt::format("the column \"{}\" occurs twice", name), "give it once");
  }
  return static_cast<std::size_t>(found - header.begin());
}

/// Whole numbers in the named columns, by twos: so many of so many; tells each line's counts and
/// its other fields, and returns the names of these.
template <std::size_t count, typename Tell>
std::vector<std::string> read_lines(std::string_view text,
                                    std::string_view file,
                                    const std::array<std::string_view, count>& columns,
                                    std::string_view form,
                                    Tell tell) {
  CsvReader csv{text, file};
  if (!is_utf8(text)) csv.refuse("the file is not UTF-8 text", "save it as CSV, UTF-8");
  const auto header = csv.next();
  if (!header) csv.refuse("the file is empty", form);
  std::array<std::size_t, count> places{};
  for (std::size_t i = 0; i < count; ++i) places[i] = column_of(*header, columns[i], csv, form);
  const auto is_label = [&](std::size_t place) {
    return std::ranges::find(places, place) == places.end();
  };
  std::vector<std::string> names;
  for (std::size_t i = 0; i < header->size(); ++i) {
    if (is_label(i)) names.push_back(header->at(i));
  }
  bool any = false;
  while (auto fields = csv.next()) {
    any = true;
    if (fields->size() != header->size()) {
      csv.refuse(
          fmt::format("{} fields, but the first line has {}", fields->size(), header->size()),
          "write one for each column");
    }
    std::array<std::int64_t, count> counts{};
    for (std::size_t i = 0; i < count; i += 2) {
      const auto some = csv_count(fields->at(places[i]));
      const auto all = csv_count(fields->at(places[i + 1]));
      if (!some || !all || *some > *all) {
        csv.refuse(fmt::format("\"{}\" of \"{}\" is no number of successes",
                               fields->at(places[i]),
                               fields->at(places[i + 1])),
                   fmt::format("write whole numbers, {} at most {}", columns[i], columns[i + 1]));
      }
      counts[i] = *some;
      counts[i + 1] = *all;
    }
    std::vector<std::string> labels;
    for (std::size_t i = 0; i < fields->size(); ++i) {
      if (is_label(i)) labels.push_back(std::move(fields->at(i)));
    }
    tell(counts, std::move(labels));
  }
  if (!any) csv.refuse("there are no counts after the first line", form);
  return names;
}

}  // namespace

CountsTable parse_counts(std::string_view text, std::string_view file) {
  CountsTable table;
  constexpr std::array<std::string_view, 2> kColumns{"k", "n"};
  table.labels = read_lines<2>(text, file, kColumns, kForm, [&](const auto& counts, auto labels) {
    table.rows.push_back(
        {.labels = std::move(labels), .successes = counts[0], .trials = counts[1]});
  });
  return table;
}

CountsTable read_counts(const std::filesystem::path& file) {
  return parse_counts(read_file(file), file.string());
}

YesTable parse_yes_counts(std::string_view text, std::string_view file) {
  YesTable table;
  table.labels =
      read_lines<4>(text, file, kYesColumns, kYesForm, [&](const auto& counts, auto labels) {
        table.rows.push_back({.labels = std::move(labels),
                              .hits = counts[0],
                              .signals = counts[1],
                              .false_alarms = counts[2],
                              .noises = counts[3]});
      });
  return table;
}

YesTable read_yes_counts(const std::filesystem::path& file) {
  return parse_yes_counts(read_file(file), file.string());
}

CountsKind kind_of_counts(std::string_view text) {
  std::vector<std::string> header;
  try {
    header = CsvReader{text, ""}.next().value_or(std::vector<std::string>{});
  } catch (const Error&) {
    return CountsKind::None;
  }
  const auto has = [&](std::string_view name) {
    return std::ranges::find(header, name) != header.end();
  };
  if (std::ranges::all_of(kYesColumns, has)) return CountsKind::Yes;
  const bool trials = has("stimulus") || has("word") || has("response");
  return (has("k") || has("n")) && !trials ? CountsKind::Successes : CountsKind::None;
}

}  // namespace bimodal::analysis

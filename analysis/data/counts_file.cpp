#include "analysis/data/counts_file.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "stimuli/base/csv_reader.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal::analysis {

namespace {

constexpr std::string_view kForm =
    "begin with a line like condition,k,n and let lines like visual,86,414 follow";

std::size_t column_of(const std::vector<std::string>& header,
                      std::string_view name,
                      const CsvReader& csv) {
  const auto found = std::ranges::find(header, name);
  if (found == header.end()) csv.refuse(fmt::format("there is no column \"{}\"", name), kForm);
  if (std::ranges::count(header, name) > 1) {
    csv.refuse(fmt::format("the column \"{}\" occurs twice", name), "give it once");
  }
  return static_cast<std::size_t>(found - header.begin());
}

}  // namespace

CountsTable parse_counts(std::string_view text, std::string_view file) {
  CsvReader csv{text, file};
  if (!is_utf8(text)) csv.refuse("the file is not UTF-8 text", "save it as CSV, UTF-8");
  const auto header = csv.next();
  if (!header) csv.refuse("the file is empty", kForm);
  const auto k = column_of(*header, "k", csv);
  const auto n = column_of(*header, "n", csv);
  CountsTable table;
  for (std::size_t i = 0; i < header->size(); ++i) {
    if (i != k && i != n) table.labels.push_back(header->at(i));
  }
  while (auto fields = csv.next()) {
    if (fields->size() != header->size()) {
      csv.refuse(
          fmt::format("{} fields, but the first line has {}", fields->size(), header->size()),
          "write one for each column");
    }
    const auto successes = csv_count(fields->at(k));
    const auto trials = csv_count(fields->at(n));
    if (!successes || !trials || *successes > *trials) {
      csv.refuse(
          fmt::format("\"{}\" of \"{}\" is no number of successes", fields->at(k), fields->at(n)),
          "write whole numbers, k at most n");
    }
    auto& row = table.rows.emplace_back();
    row.successes = *successes;
    row.trials = *trials;
    for (std::size_t i = 0; i < fields->size(); ++i) {
      if (i != k && i != n) row.labels.push_back(std::move(fields->at(i)));
    }
  }
  if (table.rows.empty()) csv.refuse("there are no counts after the first line", kForm);
  return table;
}

CountsTable read_counts(const std::filesystem::path& file) {
  return parse_counts(read_file(file), file.string());
}

}  // namespace bimodal::analysis

#include "analysis/data/feature_file.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "stimuli/base/csv_reader.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal::analysis {

namespace {

constexpr std::string_view kForm =
    "begin with a line like label,voicing,place and let one line per label follow, like "
    "p,voiceless,labial";

std::vector<std::string> names_in(const std::vector<std::string>& header, const CsvReader& csv) {
  std::vector<std::string> names(header.begin() + 1, header.end());
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (name->empty()) csv.refuse("a feature has no name", kForm);
    if (std::find(names.begin(), name, *name) == name) continue;
    csv.refuse(fmt::format("the feature \"{}\" occurs twice", *name), "give it once");
  }
  return names;
}

}  // namespace

std::vector<std::string> FeatureTable::values_of(const std::vector<std::string>& labels,
                                                 std::size_t feature) const {
  std::vector<std::string> found;
  for (const auto& label : labels) {
    const auto row = values.find(label);
    found.push_back(row == values.end() ? std::string{} : row->second.at(feature));
  }
  return found;
}

void require_stimuli(const ConfusionMatrix& matrix, const FeatureTable& features) {
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    const auto& stimulus = matrix.stimuli()[i];
    if (matrix.row_total(i) == 0 || features.values.contains(stimulus)) continue;
    throw Error{fmt::format(
        "the table of features has no line for the stimulus \"{}\"; add one (labels must agree "
        "letter by letter)",
        stimulus)};
  }
}

FeatureTable parse_features(std::string_view text, std::string_view file) {
  CsvReader csv{text, file};
  if (!is_utf8(text)) csv.refuse("the file is not UTF-8 text", "save it as CSV, UTF-8");
  const auto header = csv.next();
  if (!header || header->size() < 2) csv.refuse("there are no features in the first line", kForm);
  FeatureTable table{.features = names_in(*header, csv), .values = {}};
  while (auto fields = csv.next()) {
    if (fields->size() != header->size()) {
      csv.refuse(
          fmt::format("{} fields, but the first line has {}", fields->size(), header->size()),
          "write a value for every feature, none between two commas where it does not apply");
    }
    if (fields->front().empty()) csv.refuse("a line has no label", kForm);
    std::vector<std::string> values(fields->begin() + 1, fields->end());
    if (table.values.emplace(fields->front(), std::move(values)).second) continue;
    csv.refuse(fmt::format("the label \"{}\" occurs twice", fields->front()), "give it once");
  }
  if (table.values.empty()) csv.refuse("there are no labels after the first line", kForm);
  return table;
}

FeatureTable read_features(const std::filesystem::path& file) {
  return parse_features(read_file(file), file.string());
}

}  // namespace bimodal::analysis

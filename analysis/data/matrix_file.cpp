#include "analysis/data/matrix_file.hpp"

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "stimuli/base/csv_reader.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal::analysis {

namespace {

/// Labels of one axis, each once.
class Axis {
 public:
  Axis(const CsvReader& csv, std::string_view what) : csv_{csv}, what_{what} {}

  void add(std::string label) {
    if (label.empty()) {
      csv_.refuse(fmt::format("a {} has no label", what_), "name every row and column");
    }
    if (!known_.insert(label).second) {
      csv_.refuse(fmt::format("the {} \"{}\" occurs twice", what_, label),
                  "add the counts of the two, or give them different labels");
    }
    labels.push_back(std::move(label));
  }

  std::vector<std::string> labels;

 private:
  const CsvReader& csv_;
  std::string_view what_;
  std::set<std::string> known_;
};

}  // namespace

ConfusionMatrix parse_matrix(std::string_view text, std::string_view file) {
  constexpr std::string_view kForm =
      "begin with a line like stimulus,p,b,m and let one line per stimulus follow, like p,20,3,1";
  CsvReader csv{text, file};
  if (!is_utf8(text)) csv.refuse("the file is not UTF-8 text", "save it as CSV, UTF-8");
  const auto header = csv.next();
  if (!header) csv.refuse("there is no confusion matrix: the file is empty", kForm);
  if (header->size() < 2) csv.refuse("there are no responses in the first line", kForm);
  Axis responses{csv, "response"};
  for (std::size_t i = 1; i < header->size(); ++i) responses.add(header->at(i));
  Axis stimuli{csv, "stimulus"};
  std::vector<double> counts;
  while (auto fields = csv.next()) {
    if (fields->size() != header->size()) {
      csv.refuse(
          fmt::format("{} fields, but the first line has {}", fields->size(), header->size()),
          "write a count for every response, 0 where there was none");
    }
    stimuli.add(std::move(fields->front()));
    for (std::size_t i = 1; i < fields->size(); ++i) {
      const auto count = csv_count(fields->at(i));
      if (!count) {
        csv.refuse(fmt::format("\"{}\", the response \"{}\" to \"{}\", is no count",
                               fields->at(i),
                               header->at(i),
                               stimuli.labels.back()),
                   "write how often it was given: a whole number from 0 on (no proportions)");
      }
      counts.push_back(static_cast<double>(*count));
    }
  }
  if (stimuli.labels.empty()) csv.refuse("there are no stimuli after the first line", kForm);
  return {std::move(stimuli.labels), std::move(responses.labels), std::move(counts)};
}

ConfusionMatrix read_matrix(const std::filesystem::path& file) {
  return parse_matrix(read_file(file), file.string());
}

}  // namespace bimodal::analysis

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analysis/data/matrix_forms.hpp"
#include "analysis/data/matrix_parts.hpp"
#include "stimuli/base/csv_reader.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal::analysis {

namespace {

constexpr std::string_view kForm =
    "begin with a line like stimulus,p,b,m and let one line per stimulus follow, like p,20,3,1";
constexpr std::size_t kMostCells = 4'000'000;  ///< that a list may ask for

using Fields = std::vector<std::string>;

Refusal refusal_of(const CsvReader& csv) {
  return [&csv](std::string_view finding, std::string_view remedy) { csv.refuse(finding, remedy); };
}

double count_in(const std::string& field,
                const std::string& stimulus,
                const std::string& response,
                const CsvReader& csv) {
  const auto count = matrix_count(field);
  if (!count) {
    csv.refuse(
        fmt::format(R"("{}", the response "{}" to "{}", is no count)", field, response, stimulus),
        kCountRemedy);
  }
  return *count;
}

void require_fields(const Fields& fields, const Fields& header, const CsvReader& csv) {
  if (fields.size() == header.size()) return;
  csv.refuse(fmt::format("{} fields, but the first line has {}", fields.size(), header.size()),
             "write a count for every response, 0 where there was none");
}

ConfusionMatrix take_table(CsvReader& csv, const Fields& header) {
  const auto refuse = refusal_of(csv);
  LabelAxis responses{"response"};
  for (std::size_t i = 1; i < header.size(); ++i) responses.add(header[i], refuse);
  LabelAxis stimuli{"stimulus"};
  std::vector<double> counts;
  while (auto fields = csv.next()) {
    require_fields(*fields, header, csv);
    for (std::size_t i = 1; i < fields->size(); ++i) {
      counts.push_back(count_in(fields->at(i), fields->front(), header[i], csv));
    }
    stimuli.add(std::move(fields->front()), refuse);
  }
  return {stimuli.labels(), responses.labels(), std::move(counts)};
}

/// Which fields of a line have what a list says.
struct ListColumns {
  std::size_t stimulus = 0;
  std::size_t response = 0;
  std::size_t count = 0;
};

/// Absent if the header is that of a table.
std::optional<ListColumns> list_columns(const Fields& header) {
  const auto column = [&](std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(header, name) - header.begin());
  };
  const ListColumns columns{column("stimulus"), column("response"), column("count")};
  const auto last = std::max({columns.stimulus, columns.response, columns.count});
  if (last == header.size()) return std::nullopt;
  return columns;
}

ConfusionMatrix take_list(CsvReader& csv, const Fields& header, const ListColumns& columns) {
  const auto refuse = refusal_of(csv);
  LabelAxis stimuli{"stimulus"};
  LabelAxis responses{"response"};
  std::map<std::pair<std::size_t, std::size_t>, double> cells;
  while (const auto fields = csv.next()) {
    require_fields(*fields, header, csv);
    const auto& stimulus = fields->at(columns.stimulus);
    const auto& response = fields->at(columns.response);
    const auto count = count_in(fields->at(columns.count), stimulus, response, csv);
    const std::pair place{stimuli.index_of(stimulus, refuse), responses.index_of(response, refuse)};
    if (!cells.emplace(place, count).second) {
      csv.refuse(fmt::format(R"(the response "{}" to "{}" is counted twice)", response, stimulus),
                 "keep the lines of one condition, and one line for each stimulus and response");
    }
    if (stimuli.labels().size() * responses.labels().size() > kMostCells) {
      csv.refuse(fmt::format("more than {} cells", kMostCells), "is this the right file?");
    }
  }
  std::vector<double> counts(stimuli.labels().size() * responses.labels().size(), 0.0);
  for (const auto& [place, count] : cells) {
    counts[place.first * responses.labels().size() + place.second] = count;
  }
  return {stimuli.labels(), responses.labels(), std::move(counts)};
}

}  // namespace

TitledMatrix parse_csv_matrix(std::string_view text, std::string_view file) {
  constexpr std::string_view kCountsWanted = "write counts: of proportions no number comes back";
  CsvReader csv{text, file};
  if (!is_utf8(text)) csv.refuse("the file is not UTF-8 text", "save it as CSV, UTF-8");
  const auto remarks = csv.take_remarks();
  const auto header = csv.next();
  if (!header) csv.refuse("there is no confusion matrix: the file is empty", kForm);
  if (header->size() < 2) csv.refuse("there are no responses in the first line", kForm);
  const auto cells = remarks_called("cells", remarks);
  if (cells == std::vector<std::string>{"row proportions"})
    csv.refuse("the cells are row proportions", kCountsWanted);
  const auto columns = list_columns(*header);
  auto matrix = columns ? take_list(csv, *header, *columns) : take_table(csv, *header);
  if (matrix.stimuli().empty()) csv.refuse("there are no stimuli after the first line", kForm);
  const bool says_counts = cells == std::vector<std::string>{"counts"};
  if (!columns && !says_counts && are_proportions(matrix)) {
    csv.refuse("every row makes 1: these are proportions, no counts", kCountsWanted);
  }
  return titled(std::move(matrix), remarks);
}

}  // namespace bimodal::analysis

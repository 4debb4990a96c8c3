#include "analysis/report/exported_matrix.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "analysis/data/matrix_file.hpp"
#include "analysis/report/csv.hpp"
#include "analysis/report/json_count.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::ordered_json;

/// Titles and warnings may have names of files in them, which may be any bytes.
std::string one_line(std::string_view bytes) {
  std::string line{bytes};
  const bool text = is_utf8(line);
  std::ranges::replace_if(
      line,
      [text](char letter) {
        const auto byte = static_cast<unsigned char>(letter);
        return byte < 0x20U || byte == 0x7FU || (!text && byte >= 0x80U);
      },
      ' ');
  const auto first = line.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return line.substr(first, line.find_last_not_of(' ') - first + 1);
}

std::vector<double> row_totals(const ConfusionMatrix& matrix) {
  std::vector<double> totals;
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) totals.push_back(matrix.row_total(i));
  return totals;
}

/// The facts about the table, each line begun by `mark`.
std::string header_lines(const ExportedMatrix& exported,
                         std::string_view cells,
                         std::string_view mark) {
  std::string lines;
  const auto append = [&](std::string_view name, std::string_view fact) {
    lines += fmt::format("{} {}: {}\n", mark, name, fact);
  };
  append("title", exported.title);
  append("orientation", kOrientation);
  append("cells", cells);
  append("order", in_words(exported.order));
  append("n",
         fmt::format("{}; of each row: {}",
                     exported.matrix.total(),
                     fmt::join(row_totals(exported.matrix), ", ")));
  if (const auto trials = one_line(provenance_text(exported.provenance)); !trials.empty()) {
    append("data", trials);
  }
  for (const auto& warning : exported.warnings) append("warning", warning);
  return lines;
}

CsvField proportion_field(const ConfusionMatrix& matrix, std::size_t row, std::size_t column) {
  const auto proportion = matrix.proportion(row, column);
  return proportion ? CsvField{*proportion} : CsvField{};
}

std::string in_praat_quotes(std::string_view text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"') quoted += '"';
    quoted += letter;
  }
  return quoted + '"';
}

/// `cell(i, j)` for all, a list for each row.
template <typename Cell>
Json rows_of(const ConfusionMatrix& matrix, const Cell& cell) {
  auto rows = Json::array();
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    auto row = Json::array();
    for (std::size_t j = 0; j < matrix.responses().size(); ++j) row.push_back(cell(i, j));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

ExportedMatrix::ExportedMatrix(std::string_view called,
                               const std::vector<std::string>& warned,
                               const ConfusionMatrix& counted,
                               LabelOrder wanted)
    : title{one_line(called)}, order{wanted}, matrix{reordered(counted, wanted)} {
  for (const auto& warning : warned) warnings.push_back(one_line(warning));
}

std::string matrix_table_csv(const ExportedMatrix& exported, CellContent cells, bool header) {
  const auto& matrix = exported.matrix;
  const bool counts = cells == CellContent::Counts;
  std::string table =
      header ? header_lines(exported, counts ? "counts" : "row proportions", "#") : "";
  std::vector<CsvField> line{std::string_view{"stimulus"}};
  for (const auto& response : matrix.responses()) line.emplace_back(std::string_view{response});
  append_csv(table, line);
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    line.assign({std::string_view{matrix.stimuli()[i]}});
    for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
      line.push_back(counts ? CsvField{matrix.count(i, j)} : proportion_field(matrix, i, j));
    }
    append_csv(table, line);
  }
  return table;
}

std::string matrix_list_csv(const ExportedMatrix& exported, bool header) {
  using namespace std::string_view_literals;
  const auto& matrix = exported.matrix;
  std::string list = header ? header_lines(exported, "counts and row proportions", "#") : "";
  append_csv(
      list,
      std::vector<CsvField>{"stimulus"sv, "response"sv, "count"sv, "row_total"sv, "proportion"sv});
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
      append_csv(list,
                 std::vector<CsvField>{std::string_view{matrix.stimuli()[i]},
                                       std::string_view{matrix.responses()[j]},
                                       matrix.count(i, j),
                                       matrix.row_total(i),
                                       proportion_field(matrix, i, j)});
    }
  }
  return list;
}

std::string matrix_json(const ExportedMatrix& exported) {
  const auto& matrix = exported.matrix;
  Json json;
  json["title"] = exported.title;
  json["orientation"] = kOrientation;
  json["order"] = in_words(exported.order);
  json["n"] = json_count(matrix.total());
  json["warnings"] = exported.warnings;
  if (!exported.provenance.program.empty()) {
    json["data"] = provenance_json(exported.provenance);
  }
  json["stimuli"] = matrix.stimuli();
  json["row_totals"] = Json::array();
  for (const double total : row_totals(matrix)) json["row_totals"].push_back(json_count(total));
  json["responses"] = matrix.responses();
  json["counts"] =
      rows_of(matrix, [&](std::size_t i, std::size_t j) { return json_count(matrix.count(i, j)); });
  json["row_proportions"] = rows_of(matrix, [&](std::size_t i, std::size_t j) {
    const auto proportion = matrix.proportion(i, j);
    return proportion ? Json(*proportion) : Json(nullptr);
  });
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string matrix_praat(const ExportedMatrix& exported) {
  const auto& matrix = exported.matrix;
  std::string text = "File type = \"ooTextFile\"\nObject class = \"Confusion\"\n\n";
  text += header_lines(exported, "counts", "!");
  text += fmt::format("\nnumberOfColumns = {}\ncolumnLabels []:\n", matrix.responses().size());
  for (const auto& response : matrix.responses()) text += in_praat_quotes(response) + '\t';
  text += fmt::format("\nnumberOfRows = {}\n", matrix.stimuli().size());
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    text += fmt::format("row [{}]: {}", i + 1, in_praat_quotes(matrix.stimuli()[i]));
    for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
      text += fmt::format("\t{}", matrix.count(i, j));
    }
    text += '\n';
  }
  return text;
}

}  // namespace bimodal::analysis

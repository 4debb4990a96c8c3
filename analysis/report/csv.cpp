#include "analysis/report/csv.hpp"

#include <iterator>

#include <fmt/format.h>

namespace bimodal::analysis {

namespace {

struct FieldWriter {
  std::string& table;

  void operator()(std::monostate /*absent*/) const {}

  void operator()(std::string_view text) const {
    table += '"';
    for (const char letter : text) {
      if (letter == '"') table += '"';
      table += letter;
    }
    table += '"';
  }

  void operator()(std::int64_t number) const {
    fmt::format_to(std::back_inserter(table), "{}", number);
  }

  void operator()(double number) const { fmt::format_to(std::back_inserter(table), "{}", number); }
};

}  // namespace

void append_csv(std::string& table, std::span<const CsvField> fields) {
  bool first = true;
  for (const auto& field : fields) {
    if (!first) table += ',';
    first = false;
    std::visit(FieldWriter{table}, field);
  }
  table += '\n';
}

CsvField csv_number(const std::optional<double>& value) {
  return value ? CsvField{*value} : CsvField{};
}

}  // namespace bimodal::analysis

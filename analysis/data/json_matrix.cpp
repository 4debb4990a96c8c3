#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/data/matrix_forms.hpp"
#include "analysis/data/matrix_parts.hpp"
#include "stimuli/base/diagnostic.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/located_reading.hpp"
#include "stimuli/base/object_reader.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostOfAnAxis = 1'000'000;  ///< the size of the file sets the limit
constexpr std::size_t kMostJsonValues = 4'000'000;
constexpr std::size_t kMostTold = 10;  ///< mistakes

std::vector<std::string> take_labels(ObjectReader& object,
                                     std::string_view key,
                                     std::string_view what,
                                     Findings& findings) {
  LabelAxis axis{what};
  object.require(key, "the labels, e.g. [\"p\", \"b\"]");
  for (const auto& [value, pointer] : object.items(key, 1, kMostOfAnAxis)) {
    const Refusal refuse = [&findings, &at = pointer](std::string_view finding,
                                                      std::string_view remedy) {
      findings.error(at, std::string{finding}, std::string{remedy});
    };
    if (value->is_string()) {
      axis.add(value->get<std::string>(), refuse);
    } else {
      refuse(fmt::format("{} is no label", shown(*value)), "give a text, e.g. \"p\"");
    }
  }
  return axis.labels();
}

void take_row(const Json& row,
              const std::string& pointer,
              std::size_t responses,
              std::vector<double>& counts,
              Findings& findings) {
  if (!row.is_array() || row.size() != responses) {
    findings.error(pointer,
                   row.is_array() ? fmt::format("{} counts for {} responses", row.size(), responses)
                                  : fmt::format("{} is no list of counts", shown(row)),
                   "give a count for every response, 0 where there was none");
    return;
  }
  for (std::size_t j = 0; j < row.size(); ++j) {
    const auto count = row[j].is_number() ? row[j].get<double>() : -1.0;
    if (!is_matrix_count(count)) {
      findings.error(fmt::format("{}/{}", pointer, j),
                     fmt::format("{} is no count", shown(row[j])),
                     std::string{kCountRemedy});
    }
    counts.push_back(count);
  }
}

std::vector<double> take_counts(ObjectReader& object,
                                std::size_t stimuli,
                                std::size_t responses,
                                Findings& findings) {
  std::vector<double> counts;
  object.require("counts", "a list of counts for each stimulus, e.g. [[20, 3], [5, 15]]");
  const auto rows = object.items("counts", 1, kMostOfAnAxis);
  if (!rows.empty() && rows.size() != stimuli) {
    findings.error(object.pointer_to("counts"),
                   fmt::format("{} lists of counts, but {} stimuli", rows.size(), stimuli),
                   "give one for each stimulus");
  }
  for (const auto& [row, pointer] : rows) take_row(*row, pointer, responses, counts, findings);
  return counts;
}

TitledMatrix take_matrix(const Json& tree, Findings& findings) {
  ObjectReader object{tree, "", findings};
  TitledMatrix read;
  read.title = object.text("title", {.meaning = "what the matrix is of"}).value_or("");
  for (const auto& [value, pointer] : object.items("warnings", 0, kMostOfAnAxis)) {
    const auto warning = object.text_of(*value, pointer, {.meaning = "a warning"});
    if (warning) read.warnings.push_back(*warning);
  }
  if (const auto* const orientation = object.find("orientation");
      orientation != nullptr && *orientation != std::string{kOrientation}) {
    findings.error(object.pointer_to("orientation"),
                   fmt::format("{} is another orientation", shown(*orientation)),
                   fmt::format("turn the counts so that \"{}\" is true", kOrientation));
  }
  auto stimuli = take_labels(object, "stimuli", "stimulus", findings);
  auto responses = take_labels(object, "responses", "response", findings);
  auto counts = take_counts(object, stimuli.size(), responses.size(), findings);
  if (counts.size() != stimuli.size() * responses.size()) return read;  // which was said
  read.matrix = {std::move(stimuli), std::move(responses), std::move(counts)};
  return read;
}

std::string told(const std::vector<Diagnostic>& diagnostics) {
  std::string lines;
  for (std::size_t i = 0; i < std::min(diagnostics.size(), kMostTold); ++i) {
    lines += fmt::format("{}{}", i == 0 ? "" : "\n", describe(diagnostics[i]));
  }
  if (diagnostics.size() > kMostTold) {
    lines += fmt::format("\nand {} more", diagnostics.size() - kMostTold);
  }
  return lines;
}

}  // namespace

TitledMatrix parse_json_matrix(std::string_view text, std::string_view file) {
  std::vector<Diagnostic> diagnostics;
  auto read = read_located(text, file, diagnostics, kMostJsonValues, take_matrix);
  if (!read) throw Error{told(diagnostics)};
  return std::move(*read);
}

}  // namespace bimodal::analysis

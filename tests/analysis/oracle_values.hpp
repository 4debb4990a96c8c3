#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/data/matrix_file.hpp"
#include "analysis/statistics/dissimilarity.hpp"
#include "stimuli/base/csv_reader.hpp"
#include "stimuli/base/digest.hpp"

/// The values that R computed, in tests/oracles/values, and what it computed them of.
namespace bimodal::analysis::oracles {

inline constexpr double kTolerance = 1e-9;

inline std::filesystem::path folder() {
  return std::filesystem::path{BIMODAL_TEST_ROOT} / "oracles";
}

/// A line of a table of values, by the names of its columns.
class Line {
 public:
  explicit Line(std::map<std::string, std::string> fields) : fields_{std::move(fields)} {}

  [[nodiscard]] const std::string& text(const std::string& column) const {
    return fields_.at(column);
  }

  [[nodiscard]] double number(const std::string& column) const { return std::stod(text(column)); }

  [[nodiscard]] std::size_t index(const std::string& column) const {
    return std::stoul(text(column));
  }

 private:
  std::map<std::string, std::string> fields_;
};

inline std::vector<Line> stored_values(const std::string& name) {
  const auto file = folder() / "values" / (name + ".csv");
  const auto text = read_file(file);
  const auto path = file.string();
  CsvReader csv{text, path};
  const auto header = csv.next().value();
  std::vector<Line> lines;
  while (const auto fields = csv.next()) {
    std::map<std::string, std::string> line;
    for (std::size_t i = 0; i < header.size(); ++i) line[header[i]] = fields->at(i);
    lines.emplace_back(std::move(line));
  }
  EXPECT_FALSE(lines.empty()) << path;
  return lines;
}

inline ConfusionMatrix input(const std::string& name) {
  return read_matrix(folder() / "inputs" / (name + ".csv"));
}

inline Dissimilarities phi_of(const std::string& name) {
  return dissimilarities(input(name), DissimilarityMeasure::Phi);
}

}  // namespace bimodal::analysis::oracles

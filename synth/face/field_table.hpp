#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace bimodal::synth {

/// A CSV file of numbers: a header of column names, then one row per vertex of a cage.
class FieldTable {
 public:
  /// Throws Error naming file and line if a cell is no finite number, a row is too short or too
  /// long, or a column name is empty or occurs twice.
  explicit FieldTable(const std::filesystem::path& file);

  [[nodiscard]] std::size_t rows() const { return rows_; }

  /// Throws Error if the table lacks it.
  [[nodiscard]] std::span<const double> column(std::string_view name) const;

  /// A column of whole numbers; throws Error naming the line if one is not whole.
  [[nodiscard]] std::vector<int> whole_numbers(std::string_view name) const;

  /// The columns name_x, name_y and name_z.
  [[nodiscard]] std::vector<glm::dvec3> vectors(std::string_view name) const;

 private:
  std::string file_;
  std::size_t rows_ = 0;
  std::map<std::string, std::vector<double>, std::less<>> columns_;
};

}  // namespace bimodal::synth

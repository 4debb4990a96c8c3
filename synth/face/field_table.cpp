#include "synth/face/field_table.hpp"

#include <charconv>
#include <cmath>
#include <fstream>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::synth {

namespace {

std::vector<std::string_view> cells(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  std::vector<std::string_view> result;
  while (true) {
    const auto comma = line.find(',');
    result.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return result;
    line.remove_prefix(comma + 1);
  }
}

bool read(std::string_view cell, double& value) {
  const auto [end, problem] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return problem == std::errc{} && end == cell.data() + cell.size() && std::isfinite(value);
}

}  // namespace

FieldTable::FieldTable(const std::filesystem::path& file) : file_{file.string()} {
  std::ifstream stream{file};
  std::string line;
  if (!stream || !std::getline(stream, line)) {
    throw Error{fmt::format(
        "cannot read the head's fields '{}'; the file belongs to the program's assets", file_)};
  }
  std::vector<std::vector<double>*> targets;
  for (const auto name : cells(line)) {
    const auto [place, is_new] = columns_.try_emplace(std::string{name});
    if (name.empty() || !is_new) {
      throw Error{fmt::format("{}:1: the column name '{}' is empty or occurs twice", file_, name)};
    }
    targets.push_back(&place->second);
  }
  while (std::getline(stream, line)) {
    ++rows_;
    const auto row = cells(line);
    if (row.size() != targets.size()) {
      throw Error{fmt::format(
          "{}:{}: {} cells, but the header has {}", file_, rows_ + 1, row.size(), targets.size())};
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
      double value = 0.0;
      if (!read(row[i], value)) {
        throw Error{fmt::format("{}:{}: '{}' is not a number", file_, rows_ + 1, row[i])};
      }
      targets[i]->push_back(value);
    }
  }
}

std::span<const double> FieldTable::column(std::string_view name) const {
  const auto found = columns_.find(name);
  if (found == columns_.end()) {
    throw Error{fmt::format(
        "{}:1: the column '{}' is missing; regenerate the file with tools/head", file_, name)};
  }
  return found->second;
}

std::vector<int> FieldTable::whole_numbers(std::string_view name) const {
  std::vector<int> result;
  for (const double value : column(name)) {
    if (value != std::round(value)) {
      throw Error{fmt::format("{}:{}: column '{}' holds {}, which is not a whole number",
                              file_,
                              result.size() + 2,
                              name,
                              value)};
    }
    result.push_back(static_cast<int>(value));
  }
  return result;
}

std::vector<glm::dvec3> FieldTable::vectors(std::string_view name) const {
  const auto x = column(fmt::format("{}_x", name));
  const auto y = column(fmt::format("{}_y", name));
  const auto z = column(fmt::format("{}_z", name));
  std::vector<glm::dvec3> result(rows_);
  for (std::size_t i = 0; i < rows_; ++i) result[i] = {x[i], y[i], z[i]};
  return result;
}

}  // namespace bimodal::synth

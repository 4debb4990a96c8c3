#include "analysis/data/matrix_parts.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace bimodal::analysis {

namespace {

bool is_control(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  return byte < 0x20U || byte == 0x7FU;
}

}  // namespace

void LabelAxis::judge(const std::string& label, const Refusal& refuse) const {
  if (label.empty()) {
    refuse(fmt::format("a {} has no label", what_), "name every row and column");
  }
  if (std::ranges::any_of(label, is_control)) {
    refuse(fmt::format("the label of a {} has a line break or another control character", what_),
           "write labels in one line, without tabs");
  }
}

void LabelAxis::add(std::string label, const Refusal& refuse) {
  judge(label, refuse);
  if (!indices_.emplace(label, labels_.size()).second) {
    refuse(fmt::format("the {} \"{}\" occurs twice", what_, label),
           "add the counts of the two, or give them different labels");
  }
  labels_.push_back(std::move(label));
}

std::size_t LabelAxis::index_of(const std::string& label, const Refusal& refuse) {
  const auto [place, is_new] = indices_.emplace(label, labels_.size());
  if (is_new) {
    judge(label, refuse);
    labels_.push_back(label);
  }
  return place->second;
}

std::vector<std::string> remarks_called(std::string_view name,
                                        const std::vector<std::string>& remarks) {
  const auto start = fmt::format("{}: ", name);
  std::vector<std::string> found;
  for (const auto& line : remarks) {
    if (line.starts_with(start)) found.push_back(line.substr(start.size()));
  }
  return found;
}

TitledMatrix titled(ConfusionMatrix matrix, const std::vector<std::string>& remarks) {
  const auto titles = remarks_called("title", remarks);
  return {.title = titles.empty() ? std::string{} : titles.front(),
          .warnings = remarks_called("warning", remarks),
          .matrix = std::move(matrix)};
}

bool is_matrix_count(double number) {
  constexpr double kMost = 1e9;
  return number >= 0.0 && number <= kMost;  // and so no NaN
}

std::optional<double> matrix_count(std::string_view field) {
  const auto first = field.find_first_not_of(' ');
  if (first == std::string_view::npos || field[first] == '-') return std::nullopt;
  field = field.substr(first, field.find_last_not_of(' ') - first + 1);
  double count = 0.0;
  const auto* const end = field.data() + field.size();
  const auto [reached, fault] = std::from_chars(field.data(), end, count);
  if (fault != std::errc{} || reached != end || !is_matrix_count(count)) return std::nullopt;
  return count;
}

bool are_proportions(const ConfusionMatrix& matrix) {
  constexpr double kRounding = 0.005;  // of a proportion of two decimals
  const double tolerance = kRounding * static_cast<double>(matrix.responses().size());
  bool parts = false;
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    const double sum = matrix.row_total(i);
    if (sum > 0.0 && std::abs(sum - 1.0) > tolerance) return false;
    for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
      const double count = matrix.count(i, j);
      parts = parts || std::trunc(count) != count;
    }
  }
  return parts;
}

}  // namespace bimodal::analysis

#include "analysis/report/figures/matrix_axes.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "analysis/report/place_class.hpp"

namespace bimodal::analysis {

namespace {

/// A place of articulation, or the first member of a class; empty: labels that nothing parts.
std::string_view group_of(std::string_view label, const Arrangement& arrangement) {
  if (arrangement.classes.empty()) return place_class(label);
  for (const auto& members : arrangement.classes) {
    if (std::ranges::find(members, label) != members.end()) return members.front();
  }
  return label;
}

bool is_extra(const std::string& response, const ConfusionMatrix& matrix) {
  return place_class(response) == "no phone" &&
         std::ranges::find(matrix.stimuli(), response) == matrix.stimuli().end();
}

std::vector<std::size_t> in_order(const std::vector<std::string>& labels,
                                  const std::vector<std::string>& order) {
  std::vector<std::size_t> indices(labels.size());
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  std::ranges::stable_sort(
      indices, {}, [&](std::size_t index) { return std::ranges::find(order, labels[index]); });
  return indices;
}

std::vector<bool> borders(const std::vector<std::size_t>& shown,
                          const std::vector<std::string>& labels,
                          const Arrangement& arrangement) {
  std::vector<bool> found(shown.size(), false);
  for (std::size_t i = 1; i < shown.size(); ++i) {
    found[i] =
        group_of(labels[shown[i]], arrangement) != group_of(labels[shown[i - 1]], arrangement);
  }
  return found;
}

}  // namespace

MatrixAxes arrange(const ConfusionMatrix& matrix, const Arrangement& arrangement) {
  MatrixAxes axes;
  axes.rows = in_order(matrix.stimuli(), arrangement.order);
  axes.columns = in_order(matrix.responses(), arrangement.order);
  const auto extras =
      std::stable_partition(axes.columns.begin(), axes.columns.end(), [&](std::size_t column) {
        return !is_extra(matrix.responses()[column], matrix);
      });
  axes.extras = static_cast<std::size_t>(axes.columns.end() - extras);
  axes.row_borders = borders(axes.rows, matrix.stimuli(), arrangement);
  axes.column_borders = borders(axes.columns, matrix.responses(), arrangement);
  return axes;
}

}  // namespace bimodal::analysis

#include "analysis/report/figures/heat_map.hpp"

#include <cmath>

#include <fmt/format.h>

#include "analysis/report/figures/colour_scale.hpp"
#include "analysis/report/figures/colours.hpp"
#include "analysis/report/figures/matrix_cells.hpp"
#include "analysis/report/figures/matrix_panel.hpp"
#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kTallest = 560.0;

std::string number_in(const ConfusionMatrix& matrix,
                      std::size_t row,
                      std::size_t column,
                      HeatMapOptions::Numbers numbers) {
  if (numbers == HeatMapOptions::Numbers::Counts) {
    return matrix.count(row, column) > 0.0 ? print_count(matrix.count(row, column)) : "";
  }
  const auto share = matrix.proportion(row, column);
  if (numbers == HeatMapOptions::Numbers::None || !share || *share <= kPrintedFrom) return {};
  return print_proportion(*share);
}

std::string numbers_of(const ConfusionMatrix& matrix) {
  if (matrix.total() == 0.0) return "No responses.";
  return fmt::format("{} stimuli, {} responses, {} % correct.",
                     matrix.stimuli().size(),
                     print_count(matrix.total()),
                     print_percent(matrix.correct() / matrix.total()));
}

}  // namespace

std::string heat_map(const ConfusionMatrix& matrix, const HeatMapOptions& options) {
  const auto axes = arrange(matrix, options.arrangement);
  const MatrixPanel panel{.title = {},
                          .note_heading = "n",
                          .side = {},
                          .look =
                              [&](std::size_t row, std::size_t column) {
                                auto look =
                                    look_of_proportion(matrix, row, column, options.is_square_root);
                                look.number = number_in(matrix, row, column, options.numbers);
                                return look;
                              },
                          .note = [&](std::size_t row) { return note_of_total(matrix, row); }};
  Svg svg{points(options.width),
          fmt::format("Confusion matrix: {}", options.title),
          numbers_of(matrix) + " " + describe(options)};
  const double bottom = paint_panel(
      svg,
      matrix,
      axes,
      panel,
      {.left = 0.0, .top = 0.0, .width = svg.width(), .tallest = kTallest - kScaleHeight});
  paint_scale(svg, scale_of_proportions(options.is_square_root), 30.0, bottom + 7.0);
  return svg.finish(bottom + 7.0 + kScaleHeight);
}

std::string describe(const HeatMapOptions& options) {
  std::string text = fmt::format(
      "Rows are stimuli and columns responses in the order of {}; thin lines part {}; "
      "colours are proportions of the row on a {} scale from 0 to 1",
      options.arrangement.order_name,
      options.arrangement.classes.empty() ? "places" : "classes",
      options.is_square_root ? "square-root" : "linear");
  switch (options.numbers) {
    case HeatMapOptions::Numbers::Proportions:
      return text + ", numbers the same above .005.";
    case HeatMapOptions::Numbers::Counts:
      return text + ", numbers counts of responses.";
    case HeatMapOptions::Numbers::None:
      break;
  }
  return text + ".";
}

}  // namespace bimodal::analysis

#include "analysis/report/figures/pair_figure.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "analysis/report/figures/colour_scale.hpp"
#include "analysis/report/figures/matrix_cells.hpp"
#include "analysis/report/figures/matrix_panel.hpp"
#include "analysis/report/figures/share_axis.hpp"
#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kBetween = 8.0;  ///< panels
constexpr double kAboveScale = 7.0;
constexpr double kNote = 6.5;             ///< letters
constexpr double kLabels = 24.0;          ///< about where cells begin
constexpr double kSmallestCell = 5.8;     ///< with upright letters of 5 points
constexpr double kTallestPanel = 240.0;   ///< three of them fit on one page
constexpr double kSmallestLargest = 0.2;  ///< of the scale of differences: .01 is not to look dark

double largest_difference(const ConditionPair& pair) {
  const auto& natural = pair.natural_matrix;
  double largest = kSmallestLargest;
  for (std::size_t i = 0; i < natural.stimuli().size(); ++i) {
    for (std::size_t j = 0; j < natural.responses().size(); ++j) {
      const auto one = natural.proportion(i, j);
      const auto other = pair.synthetic_matrix.proportion(i, j);
      if (one && other) largest = std::max(largest, std::abs(*one - *other));
    }
  }
  return std::ceil(largest * 10.0 - 1e-9) / 10.0;
}

std::string describe(const ConditionPair& pair, double largest) {
  const auto significant = std::ranges::count(pair.significant, true);
  return fmt::format(
      "Row proportions of {} ({} responses) and {} ({}), and the first less the second on a scale "
      "of colours from \u2212{:g} to {:g}. {}",
      pair.natural,
      print_count(pair.natural_matrix.total()),
      pair.synthetic,
      print_count(pair.synthetic_matrix.total()),
      largest,
      largest,
      pair.significant.empty()
          ? std::string{"Differences are not tested."}
          : fmt::format(
                "{} cell{} outlined: {}.", significant, significant == 1 ? "" : "s", pair.test));
}

class PairPainter {
 public:
  PairPainter(const ConditionPair& pair, const Arrangement& arrangement, PaperWidth width)
      : pair_{pair},
        axes_{arrange(pair.natural_matrix, arrangement)},
        largest_{largest_difference(pair)},
        svg_{points(width), "Two conditions compared: " + pair.title, describe(pair, largest_)},
        natural_{proportions(pair.natural_matrix, pair.natural, "first")},
        synthetic_{proportions(pair.synthetic_matrix, pair.synthetic, "second")},
        difference_{differences()} {}

  std::string draw(PaperWidth width) {
    if (width == PaperWidth::OneColumn) return draw_below_each_other();
    const PanelPlace third{.left = 0.0, .top = 0.0, .width = (svg_.width() - 2 * kBetween) / 3};
    const bool fits = common_cell(third) >= kSmallestCell;
    return fits ? draw_side_by_side(third) : draw_difference_below();
  }

 private:
  static MatrixPanel proportions(const ConfusionMatrix& matrix,
                                 const std::string& name,
                                 const std::string& side) {
    return {.title = name,
            .note_heading = "n",
            .side = side,
            .look =
                [&matrix](std::size_t row, std::size_t column) {
                  auto look = look_of_proportion(matrix, row, column, false);
                  const auto share = matrix.proportion(row, column);
                  if (share && *share > kPrintedFrom) look.number = print_proportion(*share);
                  return look;
                },
            .note = [&matrix](std::size_t row) { return note_of_total(matrix, row); }};
  }

  MatrixPanel differences() const {
    return {.title = pair_.natural + " \u2212 " + pair_.synthetic,
            .note_heading = {},
            .side = "both",
            .look =
                [this](std::size_t row, std::size_t column) {
                  auto look = look_of_difference(
                      pair_.natural_matrix, pair_.synthetic_matrix, row, column, largest_);
                  const auto cell = row * pair_.natural_matrix.responses().size() + column;
                  look.is_outlined = !pair_.significant.empty() && pair_.significant.at(cell);
                  return look;
                },
            .note = {}};
  }

  double paint(const MatrixPanel& panel, const PanelPlace& place) {
    return paint_panel(svg_, pair_.natural_matrix, axes_, panel, place);
  }

  double paint_scale_of_proportions(double top) {
    paint_scale(svg_, scale_of_proportions(false), kLabels, top + kAboveScale);
    return top + kAboveScale + kScaleHeight;
  }

  double paint_scale_of_differences(double left, double top) {
    paint_scale(svg_, scale_of_differences(largest_, "difference"), left, top + kAboveScale);
    double bottom = top + kAboveScale + kScaleHeight;
    if (pair_.significant.empty()) return bottom;
    for (const auto& line : wrapped("outlined: " + pair_.test, kNote, svg_.width() - left)) {
      bottom += kNote + 1.0;
      svg_.text(left, bottom, line, {.size = kNote, .colour = kSoftInk});
    }
    return bottom + 2.0;
  }

  /// That all panels have where this one has its place.
  double common_cell(const PanelPlace& place) const {
    return cell_width(pair_.natural_matrix, axes_, natural_, place);
  }

  std::string draw_side_by_side(PanelPlace place) {
    place.largest_cell = common_cell(place);
    double bottom = 0.0;
    for (const auto* const panel : {&natural_, &synthetic_, &difference_}) {
      bottom = std::max(bottom, paint(*panel, place));
      place.left += place.width + kBetween;
    }
    paint_scale(svg_, scale_of_proportions(false), kLabels, bottom + kAboveScale);
    return svg_.finish(paint_scale_of_differences(svg_.width() / 2, bottom));
  }

  std::string draw_difference_below() {
    const double half = (svg_.width() - kBetween) / 2;
    double bottom = paint(natural_, {.left = 0.0, .width = half});
    bottom = std::max(bottom, paint(synthetic_, {.left = half + kBetween, .width = half}));
    bottom = paint_scale_of_proportions(bottom) + kBetween;
    bottom =
        paint(difference_,
              {.left = 0.0, .top = bottom, .width = svg_.width(), .tallest = 1.4 * kTallestPanel});
    return svg_.finish(paint_scale_of_differences(kLabels, bottom));
  }

  std::string draw_below_each_other() {
    PanelPlace place{.left = 0.0, .top = 0.0, .width = svg_.width(), .tallest = kTallestPanel};
    place.largest_cell = common_cell(place);
    place.top = paint(natural_, place) + kBetween;
    place.top = paint_scale_of_proportions(paint(synthetic_, place)) + kBetween;
    return svg_.finish(paint_scale_of_differences(kLabels, paint(difference_, place)));
  }

  const ConditionPair& pair_;
  MatrixAxes axes_;
  double largest_;
  Svg svg_;
  MatrixPanel natural_;
  MatrixPanel synthetic_;
  MatrixPanel difference_;
};

}  // namespace

std::string pair_figure(const ConditionPair& pair,
                        const Arrangement& arrangement,
                        PaperWidth width) {
  assert(pair.natural_matrix.stimuli() == pair.synthetic_matrix.stimuli());
  assert(pair.natural_matrix.responses() == pair.synthetic_matrix.responses());
  return PairPainter{pair, arrangement, width}.draw(width);
}

}  // namespace bimodal::analysis

#include "analysis/report/figures/matrix_panel.hpp"

#include <algorithm>

#include "analysis/report/figures/colours.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kLargestLetters = 8.0;
constexpr double kLargestNumbers = 7.5;
constexpr double kAxisLetters = 7.0;
constexpr double kAxisRoom = 10.0;  ///< of "stimulus" and "response"
constexpr double kTitleRoom = 12.0;
constexpr double kSpace = 2.5;

/// The measures of a panel, all in points.
struct Measures {
  double letters = 0.0;
  double numbers = 0.0;  ///< 0: none
  double gutter = 0.0;   ///< of the rows' labels
  double notes = 0.0;    ///< of the notes
  double gap = 0.0;      ///< before the extra columns
  double cell_width = 0.0;
  double cell_height = 0.0;
  double heading = 0.0;  ///< of the columns' labels
  bool phones_upright = false;
  bool extras_upright = false;
};

class PanelPainter {
 public:
  PanelPainter(const ConfusionMatrix& matrix,
               const MatrixAxes& axes,
               const MatrixPanel& panel,
               const PanelPlace& place)
      : matrix_{matrix}, axes_{axes}, panel_{panel}, place_{place} {
    measure();
  }

  [[nodiscard]] const Measures& measures() const { return measures_; }

  double paint(Svg& svg) const {
    paint_headings(svg);
    for (std::size_t i = 0; i < axes_.rows.size(); ++i) paint_row(svg, i);
    paint_borders(svg);
    for (std::size_t i = 0; i < axes_.rows.size(); ++i) paint_outlines(svg, i);
    return bottom();
  }

 private:
  const std::string& row_label(std::size_t row) const { return matrix_.stimuli()[axes_.rows[row]]; }

  const std::string& column_label(std::size_t column) const {
    return matrix_.responses()[axes_.columns[column]];
  }

  std::size_t phones() const { return axes_.columns.size() - axes_.extras; }

  double widest_label(std::size_t from, std::size_t to) const {
    double widest = 0.0;
    for (std::size_t j = from; j < to; ++j) {
      widest = std::max(widest, width_of(column_label(j), measures_.letters));
    }
    return widest;
  }

  /// How high the labels of the phones' columns are.
  double phone_labels() const {
    return measures_.phones_upright ? widest_label(0, phones()) : measures_.letters;
  }

  double widest_number() const {
    double widest = 0.0;
    for (const auto row : axes_.rows) {
      for (const auto column : axes_.columns) {
        widest = std::max(widest, width_of(panel_.look(row, column).number, 1.0));
      }
    }
    return widest;
  }

  /// Letters depend on cells and cells on the room that letters take: twice is enough.
  void measure() {
    measures_.letters = kLargestLetters;
    for (int round = 0; round < 2; ++round) {
      measure_gutters();
      const double free =
          place_.width - kAxisRoom - measures_.gutter - measures_.notes - measures_.gap;
      const double columns = std::max(1.0, static_cast<double>(axes_.columns.size()));
      measures_.cell_width = std::min(free / columns, place_.largest_cell);
      measures_.letters = std::clamp(0.9 * measures_.cell_width, kSmallestLetters, kLargestLetters);
    }
    measures_.phones_upright = widest_label(0, phones()) > measures_.cell_width;
    measures_.extras_upright = widest_label(phones(), axes_.columns.size()) > measures_.cell_width;
    measures_.heading =
        std::max(phone_labels() + kAxisRoom + (panel_.title.empty() ? 0.0 : kTitleRoom),
                 measures_.extras_upright ? widest_label(phones(), axes_.columns.size()) : 0.0);
    measure_heights();
  }

  void measure_gutters() {
    measures_.gutter = 0.0;
    for (std::size_t i = 0; i < axes_.rows.size(); ++i) {
      measures_.gutter = std::max(measures_.gutter, width_of(row_label(i), measures_.letters));
    }
    measures_.gutter += kSpace;
    measures_.notes = 0.0;
    if (panel_.note) {
      for (const auto row : axes_.rows) {
        measures_.notes =
            std::max(measures_.notes, width_of(panel_.note(row).text, measures_.letters));
      }
      measures_.notes += kSpace;
    }
    measures_.gap = axes_.extras > 0 ? 4.0 : 0.0;
  }

  void measure_heights() {
    const double rows = std::max(1.0, static_cast<double>(axes_.rows.size()));
    const double free = place_.top + place_.tallest - top();
    measures_.cell_height =
        std::max(std::min(measures_.cell_width, free / rows), measures_.letters + 0.5);
    const double widest = widest_number();
    const double fitting = std::min({(measures_.cell_width - 2.0) / std::max(widest, 0.1),
                                     0.8 * measures_.cell_height,
                                     kLargestNumbers});
    measures_.numbers = widest > 0.0 && fitting >= kSmallestLetters ? fitting : 0.0;
  }

  double left() const { return place_.left + kAxisRoom + measures_.gutter; }

  double top() const { return place_.top + measures_.heading + kSpace; }

  double row_top(std::size_t row) const {
    return top() + measures_.cell_height * static_cast<double>(row);
  }

  double bottom() const { return row_top(axes_.rows.size()); }

  double column_left(std::size_t column) const {
    return left() + measures_.cell_width * static_cast<double>(column) +
           (column >= phones() && axes_.extras > 0 ? measures_.gap : 0.0);
  }

  double phones_end() const {
    return left() + measures_.cell_width * static_cast<double>(phones());
  }

  double end() const { return column_left(axes_.columns.size()); }

  void paint_headings(Svg& svg) const {
    const double labels = top() - kSpace - phone_labels();
    svg.text(left(), labels - kAxisRoom - 3.5, panel_.title, {.size = 8.0, .is_bold = true});
    svg.text((left() + phones_end()) / 2,
             labels - 3.5,
             "response",
             {.size = kAxisLetters, .anchor = Anchor::Middle, .colour = kSoftInk});
    svg.text(
        place_.left + kAxisLetters - 0.5,
        (top() + bottom()) / 2,
        "stimulus",
        {.size = kAxisLetters, .anchor = Anchor::Middle, .colour = kSoftInk, .is_upright = true});
    for (std::size_t j = 0; j < axes_.columns.size(); ++j) paint_column_label(svg, j);
    svg.text(end() + measures_.notes,
             top() - kSpace,
             panel_.note_heading,
             {.size = measures_.letters, .anchor = Anchor::End, .is_italic = true});
  }

  void paint_column_label(Svg& svg, std::size_t column) const {
    const bool is_phone = column < phones();
    const double middle = column_left(column) + measures_.cell_width / 2;
    const bool upright = is_phone ? measures_.phones_upright : measures_.extras_upright;
    Lettering lettering{.size = measures_.letters};
    if (upright) {
      lettering.is_upright = true;
      svg.text(middle + 0.36 * measures_.letters, top() - kSpace, column_label(column), lettering);
    } else {
      lettering.anchor = Anchor::Middle;
      svg.text(middle, top() - kSpace, column_label(column), lettering);
    }
  }

  void paint_row(Svg& svg, std::size_t row) const {
    const double base = row_top(row) + measures_.cell_height / 2 + 0.36 * measures_.letters;
    svg.text(
        left() - kSpace, base, row_label(row), {.size = measures_.letters, .anchor = Anchor::End});
    for (std::size_t j = 0; j < axes_.columns.size(); ++j) paint_cell(svg, row, j);
    if (!panel_.note) return;
    const auto note = panel_.note(axes_.rows[row]);
    svg.text(end() + measures_.notes,
             base,
             note.text,
             {.size = measures_.letters,
              .anchor = Anchor::End,
              .colour = note.is_doubtful ? "#b35806" : kInk,
              .is_italic = note.is_doubtful});
  }

  Box box_of(std::size_t row, std::size_t column, double inset) const {
    return {column_left(column) + inset,
            row_top(row) + inset,
            measures_.cell_width - 2 * inset,
            measures_.cell_height - 2 * inset};
  }

  void paint_cell(Svg& svg, std::size_t row, std::size_t column) const {
    const auto look = panel_.look(axes_.rows[row], axes_.columns[column]);
    if (!look.fill.empty()) {
      svg.box(box_of(row, column, 0.0),
              {.fill = look.fill,
               .meaning = look.meaning,
               .cell = look.cell,
               .side = look.cell.empty() ? std::string_view{} : std::string_view{panel_.side}});
    }
    if (look.is_diagonal) {
      svg.box(box_of(row, column, 0.6), {.stroke = "#9aa7b4", .width = 0.4});
    }
    if (measures_.numbers == 0.0) return;
    svg.text(column_left(column) + measures_.cell_width / 2,
             row_top(row) + measures_.cell_height / 2 + 0.36 * measures_.numbers,
             look.number,
             {.size = measures_.numbers,
              .anchor = Anchor::Middle,
              .colour = look.fill.empty() ? kInk : ink_on(look.fill)});
  }

  void paint_outlines(Svg& svg, std::size_t row) const {
    for (std::size_t j = 0; j < axes_.columns.size(); ++j) {
      if (!panel_.look(axes_.rows[row], axes_.columns[j]).is_outlined) continue;
      svg.box(box_of(row, j, 0.5), {.stroke = "#000000", .width = 1.0});
    }
  }

  void paint_borders(Svg& svg) const {
    const Paint thin{.stroke = kRule, .width = 0.5};
    for (std::size_t i = 0; i < axes_.rows.size(); ++i) {
      if (!axes_.row_borders[i]) continue;
      svg.line(left(), row_top(i), phones_end(), row_top(i), thin);
      if (axes_.extras > 0) svg.line(column_left(phones()), row_top(i), end(), row_top(i), thin);
    }
    for (std::size_t j = 0; j < phones(); ++j) {
      if (!axes_.column_borders[j]) continue;
      svg.line(column_left(j), top(), column_left(j), bottom(), thin);
    }
    const Paint frame{.stroke = "#7c8894", .width = 0.6};
    svg.box({left(), top(), phones_end() - left(), bottom() - top()}, frame);
    if (axes_.extras > 0) {
      const double extras = column_left(phones());
      svg.box({extras, top(), end() - extras, bottom() - top()}, frame);
    }
  }

  const ConfusionMatrix& matrix_;
  const MatrixAxes& axes_;
  const MatrixPanel& panel_;
  PanelPlace place_;
  Measures measures_;
};

}  // namespace

double paint_panel(Svg& svg,
                   const ConfusionMatrix& matrix,
                   const MatrixAxes& axes,
                   const MatrixPanel& panel,
                   const PanelPlace& place) {
  return PanelPainter{matrix, axes, panel, place}.paint(svg);
}

double cell_width(const ConfusionMatrix& matrix,
                  const MatrixAxes& axes,
                  const MatrixPanel& panel,
                  const PanelPlace& place) {
  return PanelPainter{matrix, axes, panel, place}.measures().cell_width;
}

}  // namespace bimodal::analysis

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "analysis/report/figures.hpp"
#include "analysis/report/matrix_text.hpp"
#include "analysis/report/place_class.hpp"
#include "stimuli/base/markup.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kHeadingLength = 54.0;  ///< of "stimulus", which stands upright
constexpr double kCell = 27.0;
constexpr double kWideCell = 44.0;  ///< of a column that is no phone
constexpr double kGap = 7.0;        ///< between the phones and what is none
constexpr double kLeft = 50.0;
constexpr double kTop = 42.0;
constexpr double kRight = 50.0;
constexpr double kPrintedFrom = 0.005;
constexpr double kFewPresentations = 10;

struct Colour {
  double red;
  double green;
  double blue;
};

/// White to dark blue, lightness falling evenly: the sequential scheme "Blues" of ColorBrewer
/// (Brewer, 2003), safe for the colour-blind and in grey print.
constexpr std::array kBlues = std::to_array<Colour>({{255, 255, 255},
                                                     {222, 235, 247},
                                                     {198, 219, 239},
                                                     {158, 202, 225},
                                                     {107, 174, 214},
                                                     {66, 146, 198},
                                                     {33, 113, 181},
                                                     {8, 81, 156},
                                                     {8, 48, 107}});

std::string colour_of(double proportion) {
  const double place = std::clamp(proportion, 0.0, 1.0) * static_cast<double>(kBlues.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kBlues.size() - 2);
  const double share = place - static_cast<double>(below);
  const auto mix = [&](double Colour::*part) {
    const double from = kBlues.at(below).*part;
    return static_cast<int>(std::lround(from + share * (kBlues.at(below + 1).*part - from)));
  };
  return fmt::format(
      "#{:02x}{:02x}{:02x}", mix(&Colour::red), mix(&Colour::green), mix(&Colour::blue));
}

bool is_phone(std::string_view label) {
  return place_class(label) != "no phone";
}

/// Where columns are, left edges and widths.
struct Columns {
  std::vector<double> left;
  std::vector<double> width;
  double phones_end = kLeft;
  double end = kLeft;
};

Columns lay_out(const std::vector<std::string>& responses) {
  Columns columns;
  double x = kLeft;
  bool phones = true;
  for (const auto& response : responses) {
    if (phones && !is_phone(response)) {
      phones = false;
      columns.phones_end = x;
      x += kGap;
    }
    columns.left.push_back(x);
    columns.width.push_back(is_phone(response) ? kCell : kWideCell);
    x += columns.width.back();
  }
  if (phones) columns.phones_end = x;
  columns.end = x;
  return columns;
}

class Drawing {
 public:
  explicit Drawing(const UnitConfusions& confusions)
      : confusions_{confusions},
        matrix_{confusions.matrix},
        columns_{lay_out(matrix_.responses())},
        bottom_{kTop + kCell * static_cast<double>(matrix_.stimuli().size())} {}

  std::string draw() {
    const double width = columns_.end + kRight;
    const double height = std::max(bottom_, kTop + kHeadingLength) + 8.0;
    put("<svg class='matrix' viewBox='0 0 {:g} {:g}' width='{:g}' height='{:g}' "
        "role='img' "
        "aria-label='Confusion matrix, {}, condition {}'>\n",
        width,
        height,
        width,
        height,
        title(confusions_.unit),
        escaped(confusions_.condition));
    draw_headings();
    for (std::size_t i = 0; i < matrix_.stimuli().size(); ++i) draw_row(i);
    draw_separators();
    text_ += "</svg>\n";
    return std::move(text_);
  }

 private:
  template <typename... Arguments>
  void put(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
  }

  static double row_top(std::size_t row) { return kTop + kCell * static_cast<double>(row); }

  void draw_headings() {
    put("<text class='axis' x='{:g}' y='12' text-anchor='middle'>response</text>\n",
        (kLeft + columns_.phones_end) / 2);
    put("<text class='axis' transform='translate(11 {:g}) rotate(-90)' "
        "text-anchor='middle'>stimulus</text>\n",
        (kTop + std::max(bottom_, kTop + kHeadingLength)) / 2);
    for (std::size_t j = 0; j < matrix_.responses().size(); ++j) {
      const auto& label = matrix_.responses()[j];
      put("<text class='{}' x='{:g}' y='{:g}' text-anchor='middle'>{}</text>\n",
          is_phone(label) ? "label" : "extra",
          columns_.left[j] + columns_.width[j] / 2,
          kTop - 7,
          escaped(label));
    }
    put("<text class='extra' x='{:g}' y='{:g}' text-anchor='end' "
        "font-style='italic'>n</text>\n",
        columns_.end + kRight - 8,
        kTop - 7);
  }

  void draw_row(std::size_t row) {
    const double middle = row_top(row) + kCell / 2 + 4;
    put("<text class='label' x='{:g}' y='{:g}' text-anchor='end'>{}</text>\n",
        kLeft - 7,
        middle,
        escaped(matrix_.stimuli()[row]));
    for (std::size_t j = 0; j < matrix_.responses().size(); ++j) draw_cell(row, j, middle);
    const auto n = matrix_.row_total(row);
    put("<text class='{}' x='{:g}' y='{:g}' text-anchor='end'>{}</text>\n",
        n < kFewPresentations ? "few" : "count",
        columns_.end + kRight - 8,
        middle,
        print_count(n));
  }

  void draw_cell(std::size_t row, std::size_t column, double middle) {
    const auto share = matrix_.proportion(row, column);
    const bool diagonal = matrix_.stimuli()[row] == matrix_.responses()[column];
    if (share && *share > 0.0) {
      put("<rect x='{:g}' y='{:g}' width='{:g}' height='{:g}' fill='{}'/>",
          columns_.left[column],
          row_top(row),
          columns_.width[column],
          kCell,
          colour_of(*share));
    }
    if (diagonal) {
      put("<rect class='diagonal' x='{:g}' y='{:g}' width='{:g}' height='{:g}'/>",
          columns_.left[column] + 1,
          row_top(row) + 1,
          columns_.width[column] - 2,
          kCell - 2);
    }
    if (share && *share > kPrintedFrom) {
      put("<text class='cell' x='{:g}' y='{:g}' text-anchor='middle' fill='{}'>{}</text>",
          columns_.left[column] + columns_.width[column] / 2,
          middle - 0.5,
          *share > 0.55 ? "#fff" : "#10243e",
          print_proportion(*share));
    }
    text_ += '\n';
  }

  void line(double x1, double y1, double x2, double y2, std::string_view style) {
    put("<line class='{}' x1='{:g}' y1='{:g}' x2='{:g}' y2='{:g}'/>\n", style, x1, y1, x2, y2);
  }

  void draw_separators() {
    const auto& stimuli = matrix_.stimuli();
    for (std::size_t i = 1; i < stimuli.size(); ++i) {
      if (place_class(stimuli[i]) == place_class(stimuli[i - 1])) continue;
      line(kLeft, row_top(i), columns_.phones_end, row_top(i), "place");
      line(columns_.phones_end + kGap, row_top(i), columns_.end, row_top(i), "place");
    }
    const auto& responses = matrix_.responses();
    for (std::size_t j = 1; j < responses.size(); ++j) {
      if (!is_phone(responses[j])) break;
      if (place_class(responses[j]) == place_class(responses[j - 1])) continue;
      line(columns_.left[j], kTop, columns_.left[j], bottom_, "place");
    }
    frame(kLeft, columns_.phones_end);
    frame(columns_.phones_end + kGap, columns_.end);
  }

  void frame(double left, double right) {
    put("<rect class='frame' x='{:g}' y='{:g}' width='{:g}' height='{:g}'/>\n",
        left,
        kTop,
        right - left,
        bottom_ - kTop);
  }

  const UnitConfusions& confusions_;
  const ConfusionMatrix& matrix_;
  Columns columns_;
  double bottom_;
  std::string text_;
};

}  // namespace

std::string figure_of_confusions(const UnitConfusions& confusions) {
  return Drawing{confusions}.draw();
}

std::string figure_of_scale() {
  constexpr int kSteps = 50;
  constexpr double kWidth = 250.0;
  std::string text =
      "<svg class='scale' viewBox='0 0 290 40' width='290' height='40' role='img' "
      "aria-label='Scale of row proportions from 0 to 1'>\n";
  for (int i = 0; i < kSteps; ++i) {
    text += fmt::format("<rect x='{:g}' y='4' width='{:g}' height='14' fill='{}'/>",
                        20.0 + i * kWidth / kSteps,
                        kWidth / kSteps + 0.4,
                        colour_of((i + 0.5) / kSteps));
  }
  text += fmt::format("<rect class='frame' x='20' y='4' width='{:g}' height='14'/>\n", kWidth);
  for (int tick = 0; tick <= 4; ++tick) {
    text += fmt::format("<text class='tick' x='{:g}' y='33' text-anchor='middle'>{}</text>\n",
                        20.0 + kWidth * tick / 4.0,
                        tick == 0   ? "0"
                        : tick == 4 ? "1"
                                    : print_proportion(tick / 4.0));
  }
  return text + "</svg>\n";
}

}  // namespace bimodal::analysis

#include "analysis/report/figures/proportion_figure.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "analysis/report/figures/share_axis.hpp"
#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kNameLetters = 8.0;
constexpr double kNumberLetters = 7.5;
constexpr double kNoteLetters = 6.5;
constexpr double kBar = 8.0;        ///< height
constexpr double kDot = 1.7;        ///< radius
constexpr double kDotLevels = 8.0;  ///< dots of nearly the same proportion above each other
constexpr double kBelowBar = 3.0;
constexpr double kRowGap = 7.0;

std::string print_estimate(const ProportionBar& bar) {
  if (!bar.proportion) return "\u2013";
  auto text = print_proportion(*bar.proportion);
  if (bar.interval) {
    text += fmt::format(
        " [{}, {}]", print_proportion(bar.interval->low), print_proportion(bar.interval->high));
  }
  return text;
}

std::string describe(std::span<const ProportionBar> bars) {
  std::string text;
  for (const auto& bar : bars) {
    text += fmt::format("{}{}: {}, {} participant{}",
                        text.empty() ? "" : "; ",
                        bar.condition,
                        print_estimate(bar),
                        bar.dots.size(),
                        bar.dots.size() == 1 ? "" : "s");
  }
  return text + ".";
}

/// Where the dots of a row stand, from the highest level down, so that none covers another until
/// the levels are full.
std::vector<double> levels(const std::vector<ParticipantDot>& dots, const ShareAxis& axis) {
  std::map<long, int> met;
  std::vector<double> found;
  for (const auto& dot : dots) {
    const int rank = met[std::lround(axis.x(dot.proportion) / (2.0 * kDot + 0.4))]++;
    found.push_back(std::fmod(rank, kDotLevels));
  }
  return found;
}

class Painter {
 public:
  Painter(Svg& svg, std::span<const ProportionBar> bars) : svg_{svg}, bars_{bars} {
    double names = 0.0;
    double numbers = 0.0;
    for (const auto& bar : bars) {
      names = std::max(names, width_of(bar.condition, kNameLetters, true));
      numbers = std::max({numbers,
                          width_of(print_estimate(bar), kNumberLetters),
                          width_of(bar.note, kNoteLetters)});
    }
    names_ = std::min(names, 0.27 * svg.width());
    axis_ = {.left = names_ + 8.0, .width = svg.width() - names_ - numbers - 18.0};
  }

  double paint(const std::string& caption) {
    std::vector<double> tops{3.0};
    for (const auto& bar : bars_) tops.push_back(tops.back() + height_of(bar));
    const double bottom = paint_axis(svg_, axis_, caption, 0.0, tops.back() - kRowGap / 2);
    for (std::size_t i = 0; i < bars_.size(); ++i) paint_row(bars_[i], tops[i]);
    return bottom;
  }

 private:
  std::vector<std::string> lines_of(const ProportionBar& bar) const {
    return wrapped(bar.condition, kNameLetters * 1.1, names_ + 1.0);
  }

  double height_of(const ProportionBar& bar) const {
    double highest = 0.0;
    for (const double level : levels(bar.dots, axis_)) highest = std::max(highest, level);
    const double dots = bar.dots.empty() ? 0.0 : kBelowBar + (highest + 1.0) * (2.0 * kDot + 0.4);
    const double name = static_cast<double>(lines_of(bar).size()) * (kNameLetters + 1.0);
    return std::max({kBar + dots, name, kNumberLetters + kNoteLetters + 3.0}) + kRowGap;
  }

  void paint_row(const ProportionBar& bar, double top) {
    double base = top + kNameLetters - 1.0;
    for (const auto& line : lines_of(bar)) {
      svg_.text(0.0, base, line, {.size = kNameLetters, .is_bold = true});
      base += kNameLetters + 1.0;
    }
    paint_bar(bar, top);
    paint_dots(bar, top + kBar + kBelowBar + kDot);
    const double numbers = axis_.left + axis_.width + 10.0;
    svg_.text(numbers, top + kNumberLetters - 0.5, print_estimate(bar), {.size = kNumberLetters});
    svg_.text(numbers,
              top + kNumberLetters + kNoteLetters + 1.5,
              bar.note,
              {.size = kNoteLetters, .colour = kSoftInk});
  }

  void paint_bar(const ProportionBar& bar, double top) {
    if (!bar.proportion) return;
    const double length = axis_.x(*bar.proportion) - axis_.x(0.0);
    svg_.box({axis_.left, top, length, kBar},
             {.fill = "#9ecae1", .stroke = "#2171b5", .width = 0.5});
    if (!bar.interval) return;
    const double middle = top + kBar / 2;
    const Paint ink{.stroke = "#08306b", .width = 1.1};
    svg_.line(axis_.x(bar.interval->low), middle, axis_.x(bar.interval->high), middle, ink);
    for (const double end : {bar.interval->low, bar.interval->high}) {
      svg_.line(axis_.x(end), middle - 2.2, axis_.x(end), middle + 2.2, ink);
    }
  }

  void paint_dots(const ProportionBar& bar, double middle) {
    const auto found = levels(bar.dots, axis_);
    for (std::size_t i = 0; i < bar.dots.size(); ++i) {
      const auto meaning =
          fmt::format("{}: {}", bar.dots[i].participant, print_proportion(bar.dots[i].proportion));
      svg_.circle(axis_.x(bar.dots[i].proportion),
                  middle + found[i] * (2.0 * kDot + 0.4),
                  kDot,
                  {.fill = "#6baed6", .stroke = "#08519c", .width = 0.4, .meaning = meaning});
    }
  }

  Svg& svg_;
  std::span<const ProportionBar> bars_;
  double names_ = 0.0;
  ShareAxis axis_;
};

}  // namespace

std::string proportion_figure(std::span<const ProportionBar> bars,
                              const std::string& caption,
                              PaperWidth width) {
  Svg svg{points(width), fmt::format("Conditions: {}", caption), describe(bars)};
  const double bottom = Painter{svg, bars}.paint(caption);
  return svg.finish(bottom);
}

}  // namespace bimodal::analysis

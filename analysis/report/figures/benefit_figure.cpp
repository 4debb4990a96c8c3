#include "analysis/report/figures/benefit_figure.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/report/figures/colours.hpp"
#include "analysis/report/figures/legend.hpp"
#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kLetters = 7.0;
constexpr double kLeft = 34.0;
constexpr double kTallest = 240.0;

std::string print(double value) {
  if (value == 0.0) return "0";
  if (value == 1.0) return "1";
  return (value < 0.0 ? "\u2212" : "") + print_proportion(std::abs(value));
}

double lowest(std::span<const BenefitSeries> series) {
  double found = 0.0;
  for (const auto& one : series) {
    for (const auto& point : one.points) found = std::min(found, point.bimodal - point.auditory);
  }
  return std::floor(found * 10.0 + 1e-9) / 10.0;
}

std::string describe(std::span<const BenefitSeries> series) {
  std::string text;
  for (const auto& one : series) {
    double sum = 0.0;
    for (const auto& point : one.points) sum += point.bimodal - point.auditory;
    const auto count = one.points.size();
    text += fmt::format(
        "{}{}: {} participant{}{}",
        text.empty() ? "" : "; ",
        one.condition,
        count,
        count == 1 ? "" : "s",
        count == 0 ? ""
                   : fmt::format(", mean benefit {}", print(sum / static_cast<double>(count))));
  }
  return text + ".";
}

class Painter {
 public:
  Painter(Svg& svg, std::span<const BenefitSeries> series)
      : svg_{svg}, series_{series}, lowest_{lowest(series)} {
    width_ = svg.width() - kLeft - 10.0;
    height_ = std::min(width_ * (1.0 - lowest_), kTallest);
  }

  double paint(const std::string& auditory) {
    std::vector<LegendEntry> entries;
    for (std::size_t i = 0; i < series_.size(); ++i) {
      entries.push_back({series_[i].condition, series_colour(i), series_mark(i)});
    }
    top_ = paint_legend(svg_, entries, kLeft, 0.0) + 2.0;
    paint_grid();
    paint_limit();
    for (std::size_t i = 0; i < series_.size(); ++i) paint_points(i);
    const double bottom = top_ + height_;
    svg_.text(kLeft + width_ / 2,
              bottom + 2 * kLetters + 6.0,
              fmt::format("A: proportion correct, {}", auditory),
              {.size = kLetters, .anchor = Anchor::Middle, .colour = kSoftInk});
    svg_.text(kLetters,
              top_ + height_ / 2,
              "benefit: AV \u2212 A",
              {.size = kLetters, .anchor = Anchor::Middle, .colour = kSoftInk, .is_upright = true});
    return bottom + 2 * kLetters + 9.0;
  }

 private:
  double x(double auditory) const { return kLeft + auditory * width_; }

  double y(double benefit) const { return top_ + (1.0 - benefit) / (1.0 - lowest_) * height_; }

  void paint_grid() {
    const Paint grid{.stroke = "#e1e6ea", .width = 0.6};
    for (const double tick : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      svg_.line(x(tick), top_, x(tick), top_ + height_, grid);
      svg_.text(x(tick),
                top_ + height_ + kLetters + 2.0,
                print(tick),
                {.size = kLetters, .anchor = Anchor::Middle, .colour = kSoftInk});
    }
    for (double tick = std::ceil(lowest_ * 4.0) / 4.0; tick < 1.1; tick += 0.25) {
      svg_.line(kLeft, y(tick), x(1.0), y(tick), grid);
      svg_.text(kLeft - 3.0,
                y(tick) + 0.36 * kLetters,
                print(tick),
                {.size = kLetters, .anchor = Anchor::End, .colour = kSoftInk});
    }
    svg_.line(kLeft, y(0.0), x(1.0), y(0.0), {.stroke = "#7c8894", .width = 0.8});
  }

  void paint_limit() {
    svg_.line(x(0.0), y(1.0), x(1.0), y(0.0), {.stroke = "#7c8894", .width = 0.8, .dashes = "3 2"});
    svg_.text(x(0.45),
              y(0.55) - 10.0,
              "largest possible: 1 \u2212 A",
              {.size = kLetters, .colour = kSoftInk});
  }

  void paint_points(std::size_t index) {
    const auto colour = series_colour(index);
    for (const auto& point : series_[index].points) {
      const double benefit = point.bimodal - point.auditory;
      const auto meaning = fmt::format("{}, {}: A {}, AV {}, benefit {}",
                                       point.participant,
                                       series_[index].condition,
                                       print(point.auditory),
                                       print(point.bimodal),
                                       print(benefit));
      paint_mark(svg_,
                 series_mark(index),
                 x(point.auditory),
                 y(benefit),
                 2.4,
                 {.fill = colour, .stroke = "#ffffff", .width = 0.4, .meaning = meaning});
    }
  }

  Svg& svg_;
  std::span<const BenefitSeries> series_;
  double lowest_;
  double top_ = 0.0;
  double width_ = 0.0;
  double height_ = 0.0;
};

}  // namespace

std::string benefit_figure(std::span<const BenefitSeries> series,
                           const std::string& auditory,
                           PaperWidth width) {
  Svg svg{points(width), "Benefit of seeing the talker", describe(series)};
  const double bottom = Painter{svg, series}.paint(auditory);
  return svg.finish(bottom);
}

}  // namespace bimodal::analysis

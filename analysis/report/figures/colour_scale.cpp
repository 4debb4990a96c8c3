#include "analysis/report/figures/colour_scale.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "analysis/report/figures/colours.hpp"
#include "analysis/report/figures/share_axis.hpp"
#include "analysis/report/matrix_text.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kBarWidth = 100.0;
constexpr double kBarHeight = 7.0;
constexpr double kLetters = 6.5;
constexpr int kSteps = 50;

/// ".5", "-.5", "0", "1": as short as it is exact.
std::string short_number(double value) {
  if (value == 0.0) return "0";
  auto text = fmt::format("{:.4g}", std::abs(value));
  if (text.starts_with("0.")) text.erase(0, 1);
  return (value < 0.0 ? "\u2212" : "") + text;
}

}  // namespace

ColourScale scale_of_proportions(bool is_square_root) {
  ColourScale scale{.caption = is_square_root ? "proportion of the row, square-root scale"
                                              : "proportion of the row",
                    .colour = sequential_colour,
                    .ticks = {}};
  const std::vector<double> ticks = is_square_root ? std::vector{0.0, 0.05, 0.2, 0.5, 1.0}
                                                   : std::vector{0.0, 0.25, 0.5, 0.75, 1.0};
  for (const double tick : ticks) {
    scale.ticks.push_back({is_square_root ? std::sqrt(tick) : tick, short_number(tick)});
  }
  return scale;
}

ColourScale scale_of_differences(double largest, std::string caption) {
  ColourScale scale{.caption = std::move(caption),
                    .colour = [](double place) { return diverging_colour(2.0 * place - 1.0); },
                    .ticks = {}};
  for (const double tick : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    scale.ticks.push_back({(tick + 1.0) / 2.0, short_number(tick * largest)});
  }
  return scale;
}

void paint_scale(Svg& svg, const ColourScale& scale, double left, double top) {
  for (int step = 0; step < kSteps; ++step) {
    // Each overlaps the next a little: no seams on screens.
    const double overlap = step + 1 < kSteps ? 0.3 : 0.0;
    svg.box({left + step * kBarWidth / kSteps, top, kBarWidth / kSteps + overlap, kBarHeight},
            {.fill = scale.colour((step + 0.5) / kSteps)});
  }
  svg.box({left, top, kBarWidth, kBarHeight}, {.stroke = "#7c8894", .width = 0.5});
  for (const auto& tick : scale.ticks) {
    svg.text(left + kBarWidth * tick.at,
             top + kBarHeight + kLetters + 1.0,
             tick.label,
             {.size = kLetters, .anchor = Anchor::Middle, .colour = kSoftInk});
  }
  const double words = left + kBarWidth + 8.0;
  double base = top + kBarHeight - 1.0;
  for (const auto& line : wrapped(scale.caption, kLetters, svg.width() - words)) {
    svg.text(words, base, line, {.size = kLetters, .colour = kSoftInk});
    base += kLetters + 1.5;
  }
}

}  // namespace bimodal::analysis

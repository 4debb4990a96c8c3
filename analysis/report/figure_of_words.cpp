#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "analysis/report/figures.hpp"
#include "analysis/report/matrix_text.hpp"
#include "stimuli/base/markup.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kLeft = 56.0;
constexpr double kTop = 14.0;
constexpr double kPlotHeight = 260.0;
constexpr double kBottom = kTop + kPlotHeight;
constexpr double kDot = 3.6;  ///< radius

double height_of(double proportion) {
  return kBottom - proportion * kPlotHeight;
}

/// How far each dot stands beside its condition's line so that no two overlap: dots of nearly equal
/// height go alternately right and left.
std::vector<double> spread(const std::vector<double>& proportions) {
  std::map<int, int> met;
  std::vector<double> offsets;
  for (const double proportion : proportions) {
    const int rank = met[static_cast<int>(std::lround(height_of(proportion) / (2.0 * kDot)))]++;
    const int steps = (rank + 1) / 2;  // 0 1 1 2 2
    const double distance = (2.0 * kDot + 0.8) * steps;
    offsets.push_back(rank % 2 == 0 ? -distance : distance);
  }
  return offsets;
}

std::string scaffold(double width) {
  std::string text;
  for (int tick = 0; tick <= 4; ++tick) {
    const double share = tick / 4.0;
    text += fmt::format(
        "<line class='grid' x1='{0:g}' y1='{2:g}' x2='{1:g}' y2='{2:g}'/>"
        "<text class='tick' x='{3:g}' y='{4:g}' text-anchor='end'>{5}</text>\n",
        kLeft,
        width - 8,
        height_of(share),
        kLeft - 8,
        height_of(share) + 4,
        tick == 0   ? "0"
        : tick == 4 ? "1"
                    : print_proportion(share));
  }
  return text + fmt::format(
                    "<text class='axis' transform='translate(13 {:g}) rotate(-90)' "
                    "text-anchor='middle'>proportion of words correct</text>\n",
                    (kTop + kBottom) / 2);
}

std::string draw_dots(const Results& results, std::string_view condition, double x) {
  std::vector<const Proportion*> dots;
  for (const auto& own : results.individual) {
    if (own.measure == Measure::Word && own.condition == condition && own.proportion) {
      dots.push_back(&own);
    }
  }
  std::vector<double> proportions;
  for (const auto* dot : dots) proportions.push_back(*dot->proportion);
  const auto offsets = spread(proportions);
  std::string text;
  for (std::size_t i = 0; i < dots.size(); ++i) {
    text += fmt::format(
        "<circle class='dot' cx='{:g}' cy='{:g}' r='{:g}'><title>{}: {} of {}</title>"
        "</circle>\n",
        x + offsets[i],
        height_of(proportions[i]),
        kDot,
        escaped(dots[i]->participant),
        dots[i]->correct,
        dots[i]->judged);
  }
  return text;
}

std::string draw_pooled(const Proportion& pooled, double x) {
  std::string text;
  const double y = height_of(*pooled.proportion);
  if (pooled.interval) {
    const double low = height_of(pooled.interval->low);
    const double high = height_of(pooled.interval->high);
    text +=
        fmt::format("<path class='interval' d='M{0:g} {2:g}V{3:g}M{1:g} {2:g}h10M{1:g} {3:g}h10'/>",
                    x,
                    x - 5,
                    low,
                    high);
  }
  text += fmt::format(
      "<path class='mean' d='M{:g} {:g}h22'/>"
      "<text class='value' x='{:g}' y='{:g}'>{}</text>\n",
      x - 11,
      y,
      x + 16,
      y + 4,
      print_proportion(*pooled.proportion));
  return text;
}

}  // namespace

std::string figure_of_words(const Results& results) {
  std::size_t longest = 0;
  for (const auto& condition : results.conditions) {
    longest = std::max(longest, condition.name.size());
  }
  const double band = std::clamp(7.2 * static_cast<double>(longest) + 16.0, 150.0, 260.0);
  const double width = kLeft + band * static_cast<double>(results.conditions.size()) + 8;
  std::string text = fmt::format(
      "<svg class='words' viewBox='0 0 {0:g} {1:g}' width='{0:g}' height='{1:g}' "
      "role='img' aria-label='Proportion of words correct by condition'>\n{2}",
      width,
      kBottom + 46,
      scaffold(width));
  double x = kLeft + band / 2;
  for (const auto& pooled : results.pooled) {
    if (pooled.measure != Measure::Word || !pooled.proportion) continue;
    text += draw_dots(results, pooled.condition, x - 26);
    text += draw_pooled(pooled, x + 26);
    text += fmt::format(
        "<text class='condition' x='{0:g}' y='{1:g}' text-anchor='middle'>{2}</text>"
        "<text class='tick' x='{0:g}' y='{3:g}' text-anchor='middle'>{4} trials</text>\n",
        x,
        kBottom + 20,
        escaped(pooled.condition),
        kBottom + 37,
        pooled.judged);
    x += band;
  }
  return text + "</svg>\n";
}

}  // namespace bimodal::analysis

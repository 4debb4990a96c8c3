#include "analysis/report/figures/colours.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <span>

#include <fmt/format.h>

#include "stimuli/figures/figure.hpp"

namespace bimodal::analysis {

namespace {

constexpr std::array kBlues = std::to_array<FigureColour>(
    {0xffffff, 0xdeebf7, 0xc6dbef, 0x9ecae1, 0x6baed6, 0x4292c6, 0x2171b5, 0x08519c, 0x08306b});

constexpr std::array kPuOr = std::to_array<FigureColour>({0x7f3b08,
                                                          0xb35806,
                                                          0xe08214,
                                                          0xfdb863,
                                                          0xfee0b6,
                                                          0xffffff,
                                                          0xd8daeb,
                                                          0xb2abd2,
                                                          0x8073ac,
                                                          0x542788,
                                                          0x2d004b});

/// `place` from 0 to 1 along the steps of a scheme.
std::string mixed(std::span<const FigureColour> steps, double place) {
  const double step = std::clamp(place, 0.0, 1.0) * static_cast<double>(steps.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(step), steps.size() - 2);
  const double share = step - static_cast<double>(below);
  std::string colour = "#";
  for (const unsigned shift : {16U, 8U, 0U}) {
    const double from = steps[below] >> shift & 255U;
    const double to = steps[below + 1] >> shift & 255U;
    colour += fmt::format("{:02x}", std::lround(from + share * (to - from)));
  }
  return colour;
}

/// 0 to 1, linear in light.
double luminance(std::string_view colour) {
  std::uint32_t value = 0;
  std::from_chars(colour.data() + 1, colour.data() + colour.size(), value, 16);
  const auto linear = [&](unsigned shift) {
    const double part = static_cast<double>(value >> shift & 255U) / 255.0;
    return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(16U) + 0.7152 * linear(8U) + 0.0722 * linear(0U);
}

}  // namespace

std::string sequential_colour(double share) {
  return mixed(kBlues, share);
}

std::string diverging_colour(double share) {
  return mixed(kPuOr, (share + 1.0) / 2.0);
}

std::string_view ink_on(std::string_view colour) {
  const double light = luminance(colour) + 0.05;
  return 1.05 / light > light / 0.05 ? "#ffffff" : "#000000";
}

std::string series_colour(std::size_t index) {
  // Blue, vermilion, bluish green, reddish purple, orange, sky blue, black.
  constexpr std::array<std::size_t, 7> kOrder{2, 1, 3, 4, 5, 6, 0};
  return fmt::format("#{:06x}", figure_colour(kOrder.at(index % kOrder.size())));
}

}  // namespace bimodal::analysis

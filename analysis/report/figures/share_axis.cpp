#include "analysis/report/figures/share_axis.hpp"

#include <cmath>

#include <fmt/format.h>

#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kLetters = 7.0;

std::string quarter(double share) {
  if (share == 0.0) return "0";
  if (share == 1.0) return "1";
  return (share < 0.0 ? "\u2212" : "") + print_proportion(std::abs(share));
}

}  // namespace

double ShareAxis::x(double share) const {
  return left + (share - low) / (high - low) * width;
}

double paint_axis(
    Svg& svg, const ShareAxis& axis, std::string_view caption, double top, double bottom) {
  for (double share = std::ceil(axis.low * 4.0) / 4.0; share <= axis.high + 1e-9; share += 0.25) {
    const double x = axis.x(share);
    svg.line(x, top, x, bottom, {.stroke = "#e1e6ea", .width = share == 0.0 ? 1.0 : 0.6});
    svg.text(x,
             bottom + kLetters + 2.0,
             quarter(share),
             {.size = kLetters, .anchor = Anchor::Middle, .colour = kSoftInk});
  }
  svg.text(axis.left + axis.width / 2,
           bottom + 2 * kLetters + 5.0,
           caption,
           {.size = kLetters, .anchor = Anchor::Middle, .colour = kSoftInk});
  return bottom + 2 * kLetters + 8.0;
}

std::vector<std::string> wrapped(std::string_view text, double size, double width) {
  std::vector<std::string> lines{""};
  while (!text.empty()) {
    const auto end = text.find_first_of(" -");
    const auto word = text.substr(0, end == std::string_view::npos ? end : end + 1);
    if (!lines.back().empty() && width_of(lines.back() + std::string{word}, size) > width) {
      lines.emplace_back();
    }
    lines.back() += word;
    text.remove_prefix(word.size());
  }
  for (auto& line : lines) {
    if (line.ends_with(' ')) line.pop_back();
  }
  return lines;
}

}  // namespace bimodal::analysis

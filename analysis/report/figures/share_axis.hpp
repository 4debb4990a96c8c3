#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/figures/svg.hpp"

namespace bimodal::analysis {

/// A horizontal axis of proportions, in points.
struct ShareAxis {
  double left = 0.0;
  double width = 0.0;
  double low = 0.0;  ///< the proportion at the left end
  double high = 1.0;

  [[nodiscard]] double x(double share) const;
};

/// Faint lines at every quarter from `top` to `bottom`, their numbers and the caption below; the
/// lower edge of all this.
[[nodiscard]] double paint_axis(
    Svg& svg, const ShareAxis& axis, std::string_view caption, double top, double bottom);

/// The words of a text in lines no wider than `width` where they can be parted at spaces or
/// hyphens; a longer word stands alone.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, double size, double width);

}  // namespace bimodal::analysis

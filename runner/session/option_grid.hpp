#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "protocols/model/response.hpp"

namespace bimodal::runner {

/// A box on the screen that stands for an option: parts of the window's width and height, from its
/// upper left corner.
struct OptionBox {
  double centre_x = 0.0;
  double centre_y = 0.0;
  double width = 0.0;
  double height = 0.0;
};

/// The boxes of all options, and how large their labels are set.
struct OptionGrid {
  std::vector<OptionBox> boxes;
  double label_size = 0.0;  ///< line height, a part of the window's height
};

/// Places options in rows, in reading order, below the question: as many to a row as lets the
/// longest label be set largest, in one line. `aspect`: the window's width by its height.
[[nodiscard]] OptionGrid grid_of(std::span<const protocols::Option> options, double aspect);

/// The box in which a place of the window lies; absent: it lies in none. The left and the upper
/// edge belong to a box, the others do not.
[[nodiscard]] std::optional<std::size_t> box_at(std::span<const OptionBox> boxes,
                                                double x,
                                                double y);

}  // namespace bimodal::runner

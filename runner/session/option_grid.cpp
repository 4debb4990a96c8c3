#include "runner/session/option_grid.hpp"

#include <algorithm>
#include <string_view>

namespace bimodal::runner {

namespace {

// Parts of the window: where the grid is, and how much of a cell its box takes.
constexpr double kLeft = 0.06;
constexpr double kTop = 0.34;
constexpr double kWidth = 0.88;
constexpr double kHeight = 0.46;
constexpr double kFilled = 0.84;
constexpr double kWidestBox = 0.26;
constexpr double kHighestBox = 0.17;

constexpr double kLargestLabel = 0.06;
constexpr double kLabelPart = 0.42;  ///< of a box's height; the key stands below
constexpr double kCharacterWidth =
    0.62;  ///< by the line height: a wide letter (DejaVu Sans: o 0.53, w 0.70)
constexpr double kMargins = 0.9;  ///< of a box's width that its label may take

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

struct Cells {
  std::size_t columns = 1;
  std::size_t rows = 1;

  [[nodiscard]] double width() const { return kWidth / static_cast<double>(columns); }

  [[nodiscard]] double height() const { return kHeight / static_cast<double>(rows); }

  [[nodiscard]] double box_width() const { return std::min(kFilled * width(), kWidestBox); }

  [[nodiscard]] double box_height() const { return std::min(kFilled * height(), kHighestBox); }
};

double label_size(const Cells& cells, std::size_t longest, double aspect) {
  const double by_width =
      kMargins * cells.box_width() * aspect /
      (kCharacterWidth * static_cast<double>(std::max<std::size_t>(longest, 1)));
  return std::min({by_width, kLabelPart * cells.box_height(), kLargestLabel});
}

}  // namespace

OptionGrid grid_of(std::span<const protocols::Option> options, double aspect) {
  std::size_t longest = 0;
  for (const auto& option : options) longest = std::max(longest, characters(option.label));
  Cells best;
  double size = 0.0;
  for (std::size_t columns = options.size(); columns >= 1; --columns) {
    const Cells cells{columns, (options.size() + columns - 1) / columns};
    const double now = label_size(cells, longest, aspect);
    if (now <= size) continue;
    best = cells;
    size = now;
  }
  OptionGrid grid{.boxes = {}, .label_size = size};
  for (std::size_t i = 0; i < options.size(); ++i) {
    const auto row = i / best.columns;
    const auto in_row = std::min(best.columns, options.size() - row * best.columns);
    const double unused = static_cast<double>(best.columns - in_row) * best.width();
    grid.boxes.push_back({.centre_x = kLeft + 0.5 * unused +
                                      (static_cast<double>(i % best.columns) + 0.5) * best.width(),
                          .centre_y = kTop + (static_cast<double>(row) + 0.5) * best.height(),
                          .width = best.box_width(),
                          .height = best.box_height()});
  }
  return grid;
}

std::optional<std::size_t> box_at(std::span<const OptionBox> boxes, double x, double y) {
  const auto found = std::ranges::find_if(boxes, [&](const OptionBox& box) {
    const double from_left = x - (box.centre_x - 0.5 * box.width);
    const double from_top = y - (box.centre_y - 0.5 * box.height);
    return from_left >= 0.0 && from_left < box.width && from_top >= 0.0 && from_top < box.height;
  });
  if (found == boxes.end()) return std::nullopt;
  return static_cast<std::size_t>(found - boxes.begin());
}

}  // namespace bimodal::runner

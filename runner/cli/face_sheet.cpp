#include "runner/cli/face_sheet.hpp"

#include <algorithm>

#include "stimuli/picture/drawing.hpp"

namespace bimodal::runner {

namespace {

constexpr std::int64_t kMargin = 8;
constexpr std::int64_t kScale = 2;
constexpr std::int64_t kLine = kLetter.height * kScale + 6;
constexpr Colour kPaper{255, 255, 255};
constexpr Colour kInk{20, 20, 20};

bool has_captions(const SheetRow& row) {
  return std::ranges::any_of(row.cells, [](const auto& cell) { return !cell.caption.empty(); });
}

std::int64_t height_of(const SheetRow& row, std::int64_t picture_height) {
  return kMargin + (row.title.empty() ? 0 : kLine) + picture_height +
         (has_captions(row) ? kLine : 0);
}

}  // namespace

Image contact_sheet(const std::vector<SheetRow>& rows) {
  const auto& first = rows.front().cells.front().picture;
  const auto cell_width = static_cast<std::int64_t>(first.width);
  const auto cell_height = static_cast<std::int64_t>(first.height);
  std::int64_t height = kMargin;
  std::int64_t width = 0;
  for (const auto& row : rows) {
    height += height_of(row, cell_height);
    const auto cells = static_cast<std::int64_t>(row.cells.size());
    width = std::max({width, cells * cell_width, text_width(row.title, kScale)});
  }
  Image sheet = blank_image(
      static_cast<std::size_t>(width + 2 * kMargin), static_cast<std::size_t>(height), kPaper);
  std::int64_t top = kMargin;
  for (const auto& row : rows) {
    const auto pictures = top + (row.title.empty() ? 0 : kLine);
    draw_text(sheet, {kMargin, top}, row.title, kInk, kScale);
    std::int64_t left = kMargin;
    for (const auto& cell : row.cells) {
      paste(sheet, {left, pictures}, cell.picture);
      const auto middle = (cell_width - text_width(cell.caption, kScale)) / 2;
      draw_text(sheet, {left + middle, pictures + cell_height + 4}, cell.caption, kInk, kScale);
      left += cell_width;
    }
    top += height_of(row, cell_height);
  }
  return sheet;
}

}  // namespace bimodal::runner

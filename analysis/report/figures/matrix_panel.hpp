#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "analysis/report/figures/matrix_axes.hpp"
#include "analysis/report/figures/svg.hpp"

namespace bimodal::analysis {

/// What one cell shows.
struct CellLook {
  std::string fill;     ///< a colour; empty: none
  std::string number;   ///< printed where there is room; empty: none
  std::string meaning;  ///< the cell in words; empty: not told
  std::string cell;     ///< "F V": stimulus and response, where there is one; empty: not told
  bool is_outlined = false;
  bool is_diagonal = false;
};

/// What stands at the end of a row.
struct RowNote {
  std::string text;
  bool is_doubtful = false;  ///< of too few presentations
};

/// A matrix drawn cell by cell. Functions are given numbers of rows and columns of the matrix.
struct MatrixPanel {
  std::string title;         ///< above it; empty: none
  std::string note_heading;  ///< above the notes; empty: none
  std::string
      side;  ///< "first", "second", "both": of two matrices in a figure whose; empty: of one
  std::function<CellLook(std::size_t, std::size_t)> look;
  std::function<RowNote(std::size_t)> note;  ///< at the right of rows; empty: none
};

/// Where a panel goes, in points.
struct PanelPlace {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double tallest = 600.0;      ///< cells are squeezed to keep within it
  double largest_cell = 26.0;  ///< its width
};

/// Smaller letters are not drawn at all.
inline constexpr double kSmallestLetters = 5.0;

/// Draws the panel with its labels; its lower edge. Labels that are wider than their columns stand
/// upright, numbers that had to be smaller than 5 points are left out.
[[nodiscard]] double paint_panel(Svg& svg,
                                 const ConfusionMatrix& matrix,
                                 const MatrixAxes& axes,
                                 const MatrixPanel& panel,
                                 const PanelPlace& place);

/// How wide the panel's cells would be there, in points.
[[nodiscard]] double cell_width(const ConfusionMatrix& matrix,
                                const MatrixAxes& axes,
                                const MatrixPanel& panel,
                                const PanelPlace& place);

}  // namespace bimodal::analysis

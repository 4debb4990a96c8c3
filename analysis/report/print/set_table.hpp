#pragma once

#include <vector>

#include <cairo.h>

#include "analysis/report/print/blocks.hpp"

namespace bimodal::analysis {

/// A table with its column widths; sizes in points.
class SetTable {
 public:
  /// Borrows the block. Letters become smaller where columns would not have room for their words.
  SetTable(cairo_t* context, const Block& table, double width);

  /// Of the heading, or of one row of the body.
  [[nodiscard]] double height_of_head() const;
  [[nodiscard]] double height_of_row(std::size_t row) const;

  /// The upper left corner is there; with the rules above and below the heading.
  void paint_head(double x, double y) const;
  void paint_row(std::size_t row, double x, double y) const;
  /// The rule below the table.
  void paint_end(double x, double y) const;

 private:
  struct Room {
    double wanted = 0.0;  ///< all words in one line
    double least = 0.0;   ///< no word parted
  };

  [[nodiscard]] std::vector<Room> measure() const;
  void share_out(double width);
  [[nodiscard]] double height_of(const TableRow& row) const;
  void paint(const TableRow& row, double x, double y) const;
  void rule(double x, double y, double thickness) const;
  [[nodiscard]] double width() const;

  cairo_t* context_;
  const Block& table_;
  double letters_ = 8.0;
  std::vector<double> columns_;  ///< widths
};

}  // namespace bimodal::analysis

#include "analysis/report/print/set_table.hpp"

#include <algorithm>
#include <numeric>

#include "analysis/report/print/set_text.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kSmallestLetters = 5.0;
constexpr double kBetween = 8.0;        ///< columns
constexpr double kAround = 1.8;         ///< rows, above and below
constexpr double kLongestWord = 110.0;  ///< longer ones (hashes) may be parted
constexpr double kHeavy = 0.9;
constexpr double kLight = 0.5;

TextLook look_of(const TableCell& cell, double letters) {
  return {.size = letters, .is_bold = cell.is_heading, .is_right = cell.is_number};
}

}  // namespace

SetTable::SetTable(cairo_t* context, const Block& table, double width)
    : context_{context}, table_{table} {
  share_out(width);
}

std::vector<SetTable::Room> SetTable::measure() const {
  std::vector<Room> rooms;
  for (const auto* const rows : {&table_.head, &table_.body}) {
    for (const auto& row : *rows) {
      if (rooms.size() < row.cells.size()) rooms.resize(row.cells.size());
      for (std::size_t k = 0; k < row.cells.size(); ++k) {
        const auto& cell = row.cells[k];
        const SetText text{context_, cell.words, look_of(cell, letters_), -1.0};
        const bool is_whole = cell.is_number && !cell.is_heading;
        const double word = is_whole ? text.width() : std::min(text.widest_word(), kLongestWord);
        rooms[k].wanted = std::max(rooms[k].wanted, text.width() + 0.5);
        rooms[k].least = std::max(rooms[k].least, word + 0.5);
      }
    }
  }
  return rooms;
}

/// What all columns need at least, and of what is left to each in proportion to what it lacks.
void SetTable::share_out(double width) {
  auto rooms = measure();
  if (rooms.empty()) return;
  const double free = width - kBetween * static_cast<double>(rooms.size() - 1);
  const auto sum = [&](double Room::*part) {
    return std::accumulate(rooms.begin(), rooms.end(), 0.0, [&](double so_far, const Room& room) {
      return so_far + room.*part;
    });
  };
  while (sum(&Room::least) > free && letters_ > kSmallestLetters) {
    letters_ -= 0.5;
    rooms = measure();
  }
  const double least = sum(&Room::least);
  const double lacking = sum(&Room::wanted) - least;
  const double share = lacking > 0.0 ? std::clamp((free - least) / lacking, 0.0, 1.0) : 0.0;
  const double squeeze = least > free ? free / least : 1.0;
  for (const auto& room : rooms) {
    columns_.push_back(squeeze * (room.least + share * (room.wanted - room.least)));
  }
}

double SetTable::width() const {
  return std::accumulate(columns_.begin(), columns_.end(), 0.0) +
         kBetween * static_cast<double>(columns_.size() - 1);
}

double SetTable::height_of(const TableRow& row) const {
  double highest = letters_;
  for (std::size_t k = 0; k < row.cells.size(); ++k) {
    const SetText text{context_, row.cells[k].words, look_of(row.cells[k], letters_), columns_[k]};
    highest = std::max(highest, text.height());
  }
  return highest + 2 * kAround;
}

double SetTable::height_of_head() const {
  double sum = kAround;
  for (const auto& row : table_.head) sum += height_of(row);
  return sum;
}

double SetTable::height_of_row(std::size_t row) const {
  return height_of(table_.body.at(row));
}

void SetTable::rule(double x, double y, double thickness) const {
  set_colour(context_, "#1b2733");
  cairo_set_line_width(context_, thickness);
  cairo_move_to(context_, x, y);
  cairo_line_to(context_, x + width(), y);
  cairo_stroke(context_);
}

void SetTable::paint_head(double x, double y) const {
  rule(x, y, kHeavy);
  for (const auto& row : table_.head) {
    paint(row, x, y);
    y += height_of(row);
  }
  if (!table_.head.empty()) rule(x, y, kLight);
}

void SetTable::paint_row(std::size_t row, double x, double y) const {
  if (table_.body[row].begins_group && row > 0) rule(x, y, 0.25);
  paint(table_.body[row], x, y);
}

void SetTable::paint_end(double x, double y) const {
  rule(x, y, kHeavy);
}

void SetTable::paint(const TableRow& row, double x, double y) const {
  for (std::size_t k = 0; k < row.cells.size(); ++k) {
    const SetText text{context_, row.cells[k].words, look_of(row.cells[k], letters_), columns_[k]};
    text.paint(x, y + kAround);
    x += columns_[k] + kBetween;
  }
}

}  // namespace bimodal::analysis

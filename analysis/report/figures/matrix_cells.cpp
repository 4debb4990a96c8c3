#include "analysis/report/figures/matrix_cells.hpp"

#include <cmath>

#include <fmt/format.h>

#include "analysis/report/figures/colours.hpp"
#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

constexpr double kFewPresentations = 10;

bool is_diagonal(const ConfusionMatrix& matrix, std::size_t row, std::size_t column) {
  return matrix.stimuli()[row] == matrix.responses()[column];
}

/// "F V".
std::string cell_name(const ConfusionMatrix& matrix, std::size_t row, std::size_t column) {
  return fmt::format("{} {}", matrix.stimuli()[row], matrix.responses()[column]);
}

/// "-.12", with a real minus sign.
std::string print_difference(double difference) {
  return (difference < 0.0 ? "\u2212" : "") + print_proportion(std::abs(difference));
}

}  // namespace

CellLook look_of_proportion(const ConfusionMatrix& matrix,
                            std::size_t row,
                            std::size_t column,
                            bool is_square_root) {
  CellLook look;
  look.is_diagonal = is_diagonal(matrix, row, column);
  const auto share = matrix.proportion(row, column);
  if (!share) {
    look.fill = kUnknown;
    look.meaning = fmt::format("{} was not presented", matrix.stimuli()[row]);
    return look;
  }
  if (*share == 0.0) return look;
  look.cell = cell_name(matrix, row, column);
  look.fill = sequential_colour(is_square_root ? std::sqrt(*share) : *share);
  look.meaning = fmt::format("{} answered {}: {} ({} of {})",
                             matrix.stimuli()[row],
                             matrix.responses()[column],
                             print_proportion(*share),
                             print_count(matrix.count(row, column)),
                             print_count(matrix.row_total(row)));
  return look;
}

CellLook look_of_difference(const ConfusionMatrix& one,
                            const ConfusionMatrix& other,
                            std::size_t row,
                            std::size_t column,
                            double largest) {
  CellLook look;
  look.is_diagonal = is_diagonal(one, row, column);
  const auto share_of_one = one.proportion(row, column);
  const auto share_of_other = other.proportion(row, column);
  if (!share_of_one || !share_of_other) {
    look.fill = kUnknown;
    look.meaning = fmt::format("{} was not presented in both", one.stimuli()[row]);
    return look;
  }
  const double difference = *share_of_one - *share_of_other;
  if (*share_of_one == 0.0 && *share_of_other == 0.0) return look;
  look.cell = cell_name(one, row, column);
  look.fill = diverging_colour(difference / largest);
  look.meaning = fmt::format("{} answered {}: {} and {}, difference {}",
                             one.stimuli()[row],
                             one.responses()[column],
                             print_proportion(*share_of_one),
                             print_proportion(*share_of_other),
                             print_difference(difference));
  if (std::abs(difference) > kPrintedFrom) look.number = print_difference(difference);
  return look;
}

RowNote note_of_total(const ConfusionMatrix& matrix, std::size_t row) {
  const double total = matrix.row_total(row);
  return {print_count(total), total < kFewPresentations};
}

}  // namespace bimodal::analysis

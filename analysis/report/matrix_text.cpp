#include "analysis/report/matrix_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/report/exported_matrix.hpp"
#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

std::vector<std::size_t> columns_with_responses(const ConfusionMatrix& matrix) {
  std::vector<std::size_t> columns;
  for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
    for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
      if (matrix.count(i, j) == 0) continue;
      columns.push_back(j);
      break;
    }
  }
  return columns;
}

}  // namespace

std::string matrix_csv(const ConfusionMatrix& matrix) {
  return matrix_table_csv({"", {}, matrix, LabelOrder::Given}, CellContent::Counts, false);
}

std::string matrix_text(const std::string& title, const ConfusionMatrix& matrix) {
  const auto columns = columns_with_responses(matrix);
  std::size_t label_width = 8;
  for (const auto& stimulus : matrix.stimuli())
    label_width = std::max(label_width, stimulus.size() + 1);
  std::string text = fmt::format(
      "{}: row proportions (rows: stimuli, columns: responses)\n\n{:>{}}", title, "", label_width);
  const auto width = [&](std::size_t column) {
    return std::max<std::size_t>(5, matrix.responses()[column].size() + 1);
  };
  for (const auto j : columns) text += fmt::format("{:>{}}", matrix.responses()[j], width(j));
  text += fmt::format("{:>8}\n", "n");
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    text += fmt::format("{:>{}}", matrix.stimuli()[i], label_width);
    for (const auto j : columns) {
      const auto share = matrix.proportion(i, j);
      const bool shown = share && *share > 0.0;
      text += fmt::format("{:>{}}", shown ? print_proportion(*share) : "", width(j));
    }
    text += fmt::format("{:>8}\n", print_count(matrix.row_total(i)));
  }
  const auto total = matrix.total();
  text += total == 0 ? std::string{"\nNo responses.\n"}
                     : fmt::format("\nCorrect: {} of {} ({} %).\n",
                                   print_count(matrix.correct()),
                                   print_count(total),
                                   print_percent(matrix.correct() / total));
  return text;
}

std::string left_out_text(const UnitConfusions& confusions) {
  return fmt::format("Not in the table: ambiguous alignments {}, words without this unit {}{}.\n",
                     confusions.ambiguous,
                     confusions.lacking,
                     confusions.without_phones == 0
                         ? ""
                         : fmt::format(" ({} of unknown phones)", confusions.without_phones));
}

}  // namespace bimodal::analysis

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "analysis/report/comparison_table.hpp"
#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

constexpr std::size_t kListed = 10;  ///< contrasts and cells in the text

std::string accuracy_lines(const FaceComparison& comparison) {
  const auto& cells = comparison.cells;
  auto text = fmt::format("  n: {} and {} responses; correct {} and {}",
                          print_count(cells.n_one),
                          print_count(cells.n_other),
                          print_decimals(cells.correct_one),
                          print_decimals(cells.correct_other));
  if (cells.accuracy_ratio) text += fmt::format("; ratio {}", print_decimals(cells.accuracy_ratio));
  text += '\n';
  if (comparison.ratio) {
    text += fmt::format("  Words correct, ratio: {}", print_decimals(comparison.ratio));
    if (comparison.ratio_interval) {
      text += fmt::format(" [{}, {}]",
                          print_decimals(comparison.ratio_interval->low),
                          print_decimals(comparison.ratio_interval->high));
    }
    text += fmt::format(" ({})\n", comparison.ratio_method);
  }
  if (!cells.not_compared.empty()) {
    text += fmt::format("  Stimuli with responses in one only, not compared: {}\n",
                        fmt::join(cells.not_compared, ", "));
  }
  return text;
}

/// Words set in lines of at most 90 letters, indented by two.
std::string wrapped(const std::string& text) {
  constexpr std::size_t kWidth = 90;
  std::string lines;
  std::string line = " ";
  std::istringstream words{text};
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > kWidth) {
      lines += line + '\n';
      line = " ";
    }
    line += ' ' + word;
  }
  return lines + line + '\n';
}

/// Shares of a ceiling near 0 say nothing.
std::string low_ceiling_line(const NoiseCeiling& ceiling) {
  constexpr double kLow = 0.5;
  if (ceiling.within.value_or(0.0) >= kLow) return {};
  return "  The ceiling of the cells off the diagonal is low: too few responses to tell faces "
         "apart,\n"
         "  and its share says little.\n";
}

std::string agreement_line(std::string_view name,
                           const CellAgreement& cells,
                           const NoiseCeiling& ceiling) {
  return fmt::format("  {:<14}{:>7}{:>9}{:>10}{:>8}{:>11}{:>9}{:>8}{:>11}\n",
                     name,
                     cells.cells,
                     print_decimals(cells.pearson),
                     print_decimals(cells.spearman),
                     print_decimals(cells.rms_difference, 3),
                     print_decimals(ceiling.across),
                     print_decimals(ceiling.within),
                     print_decimals(ceiling.share),
                     print_decimals(ceiling.corrected));
}

std::string agreement_lines(const FaceComparison& comparison) {
  return fmt::format("\n  {:<14}{:>7}{:>9}{:>10}{:>8}{:>11}{:>9}{:>8}{:>11}\n",
                     "",
                     "cells",
                     "r",
                     "Spearman",
                     "RMSD",
                     "r, halves",
                     "ceiling",
                     "share",
                     "full ceil.") +
         agreement_line("all", comparison.cells.all, comparison.ceiling_all) +
         agreement_line(
             "off-diagonal", comparison.cells.off_diagonal, comparison.ceiling_off_diagonal) +
         fmt::format(
             "  Ceiling: r of one half of \"{}\" with its other half ({} halves of {}), against "
             "halves\n  of the two; share 1 is as alike as one face is to itself. Full ceil.: what "
             "r of all\n  responses could be (Spearman & Brown). r of all cells is inflated by the "
             "diagonal.\n",
             comparison.one,
             comparison.ceiling_all.splits,
             comparison.ceiling_all.by_participants ? "the participants" : "the responses") +
         low_ceiling_line(comparison.ceiling_off_diagonal);
}

std::string mantel_line(std::string_view name, const std::optional<Mantel>& found) {
  if (!found) return fmt::format("  Mantel, {}: too few stimuli, or no spread\n", name);
  return fmt::format("  Mantel, {}: r = {}, {} ({} {})\n",
                     name,
                     print_decimals(found->r),
                     print_p(found->p),
                     found->permutations,
                     found->enumerated ? "orders, all" : "permutations");
}

std::string test_lines(const FaceComparison& comparison) {
  const auto& cells = comparison.cells;
  const auto& permutation = comparison.permutation;
  auto text = "\n" + wrapped("Are the confusions the same? " + design_in_words(comparison));
  if (permutation.p) {
    text +=
        fmt::format("  Pearson X2 = {:.2f}: {} by {} permutations of {} trials ({} left out).\n",
                    permutation.chi_square,
                    print_p(*permutation.p),
                    permutation.permutations,
                    permutation.used,
                    permutation.left_out);
    text += fmt::format("  {} correct, second less first: {} ({}).\n",
                        comparison.exchanged_responses ? "Responses" : "Words",
                        print_decimals(permutation.accuracy_difference),
                        print_p(permutation.accuracy_p.value_or(1.0)));
  }
  text += fmt::format(
      "  For description: X2({}) = {:.2f}{}; G = {:.2f} (its p is wrong for sparse tables)\n",
      cells.degrees,
      cells.chi_square,
      cells.chi_square_p ? ", " + print_p(*cells.chi_square_p) + " if responses were independent"
                         : std::string{},
      cells.g);
  text += mantel_line("phi", comparison.mantel_phi);
  text += mantel_line("confusions", comparison.mantel_confusion);
  return text + "  (Mantel asks only whether labels matter at all; nearly any two faces pass.)\n";
}

std::string row_lines(const FaceComparison& comparison) {
  auto text = fmt::format("\n  {:<12}{:>8}{:>8}{:>12}{:>10}{:>5}\n",
                          "stimulus",
                          "n 1",
                          "n 2",
                          "JSD (bits)",
                          "X2",
                          "df");
  for (const auto& row : comparison.cells.rows) {
    text += fmt::format("  {:<12}{:>8}{:>8}{:>12.3f}{:>10.2f}{:>5}\n",
                        row.stimulus,
                        print_count(row.n_one),
                        print_count(row.n_other),
                        row.divergence,
                        row.chi_square,
                        row.degrees);
  }
  return text;
}

std::string cell_lines(const FaceComparison& comparison) {
  if (!comparison.permutation.p) return {};
  const auto cells = significant_cells(comparison);
  if (cells.empty()) {
    return "\n  No single cell differs (permutation, false discovery rate .05).\n";
  }
  auto text = fmt::format(
      "\n  Cells that differ (permutation, false discovery rate .05): {}{}\n",
      cells.size(),
      cells.size() > kListed ? fmt::format("; the {} largest (--csv has all):", kListed) : ":");
  for (std::size_t i = 0; i < std::min(cells.size(), kListed); ++i) {
    const auto& cell = cells[i];
    text += fmt::format(
        "  {} answered {}: {} and {}, q {}\n",
        comparison.one_matrix.stimuli()[cell.stimulus],
        comparison.one_matrix.responses()[cell.response],
        print_decimals(comparison.one_matrix.proportion(cell.stimulus, cell.response)),
        print_decimals(comparison.other_matrix.proportion(cell.stimulus, cell.response)),
        cell.q < 0.001 ? "< .001" : "= " + print_decimals(cell.q, 3));
  }
  return text;
}

std::string contrast_lines(const FaceComparison& comparison) {
  std::string text;
  std::size_t told = 0;
  for (const auto& contrast : comparison.contrasts) {
    if (told == kListed || contrast.loss() < kLossWorthTelling) break;
    text += fmt::format(
        "  {}. {}\n", ++told, contrast_in_words(contrast, comparison.one, comparison.other));
  }
  if (text.empty()) {
    return fmt::format("\n  \"{}\" shows every contrast that \"{}\" shows (phi within .10).\n",
                       comparison.other,
                       comparison.one);
  }
  const auto& p = comparison.permutation.p;
  return fmt::format("\n  What \"{}\" fails to show, the largest loss first{}:\n",
                     comparison.other,
                     p && *p > kFalseDiscoveryRate
                         ? " (the confusions as a whole do not differ: maybe chance)"
                         : "") +
         text;
}

std::string in_degrees(double phi) {
  if (phi >= 0.8) return "clearly";
  if (phi >= 0.5) return "fairly";
  if (phi >= 0.25) return "hardly";
  return "not";
}

}  // namespace

std::string contrast_in_words(const Contrast& contrast,
                              const std::string& one,
                              const std::string& other) {
  return fmt::format(
      "{} and {}: told apart {} in \"{}\" (phi {}, taken for each other in {} of the responses), "
      "{} in \"{}\" (phi {}, {})",
      contrast.stimulus,
      contrast.counterpart,
      in_degrees(contrast.one),
      one,
      print_decimals(contrast.one),
      print_decimals(contrast.confused_one),
      in_degrees(contrast.other),
      other,
      print_decimals(contrast.other),
      print_decimals(contrast.confused_other));
}

std::string design_in_words(const FaceComparison& comparison) {
  if (comparison.exchanged_responses) {
    return "Responses to the same stimulus are exchanged one by one, as if all were independent: "
           "matrices do not tell who gave them. Give trials for a test by the design.";
  }
  switch (comparison.permutation.randomisation) {
    case Randomisation::WithinItems:
      return "Participants met words in both conditions: the conditions are exchanged within "
             "participant x word.";
    case Randomisation::BetweenParticipants:
      return "Each participant met each word in one condition: whose list had which condition is "
             "exchanged between participants.";
    case Randomisation::WithinLists:
      return "Participants met different lists in the two conditions: conditions are exchanged "
             "between the participants who met a list, list by list (errs on the safe side).";
    case Randomisation::None:
      break;
  }
  return "No test: every word was met in one of the two conditions only, so that words and "
         "conditions cannot be told apart.";
}

std::string comparison_text(const FaceComparison& comparison) {
  return fmt::format("{}\"{}\" (1) and \"{}\" (2): how alike their confusions are\n\n",
                     comparison.title.empty() ? "" : comparison.title + ", ",
                     comparison.one,
                     comparison.other) +
         accuracy_lines(comparison) + agreement_lines(comparison) + test_lines(comparison) +
         row_lines(comparison) + cell_lines(comparison) + contrast_lines(comparison);
}

}  // namespace bimodal::analysis

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/report/comparison_table.hpp"
#include "analysis/report/page_parts.hpp"
#include "analysis/report/printed_number.hpp"
#include "analysis/report/report_figures.hpp"
#include "stimuli/base/markup.hpp"

namespace bimodal::analysis {

namespace {

constexpr std::size_t kCellsTold = 20;
constexpr std::size_t kContrastsTold = 10;

std::string row(std::string_view measure, std::string_view value, std::string_view basis) {
  return fmt::format(
      "<tr><th scope='row'>{}</th><td class='estimate'>{}</td><td class='note'>{}</td></tr>\n",
      measure,
      value,
      basis);
}

/// "p = .023" with p as statistics have it.
std::string italic_p(double p) {
  return "<i>p</i>" + escaped(print_p(p).substr(1));
}

std::string row_of_correct(const FaceComparison& comparison) {
  const auto& cells = comparison.cells;
  return row("Proportion correct",
             fmt::format("{} and {}; ratio {}",
                         print_signed(cells.correct_one),
                         print_signed(cells.correct_other),
                         print_signed(cells.accuracy_ratio)),
             fmt::format("{} and {} responses, all columns",
                         print_count(cells.n_one),
                         print_count(cells.n_other)));
}

std::string row_of_agreement(std::string_view which,
                             const CellAgreement& cells,
                             const NoiseCeiling& ceiling) {
  return row(
      fmt::format("<i>r</i> of {} cells", which),
      fmt::format("{} (Spearman {})", print_signed(cells.pearson), print_signed(cells.spearman)),
      ceiling.within
          ? fmt::format("{} cells. Of halves: {} across faces where one face has {} with "
                        "itself, share {} ({} halves of the {})",
                        cells.cells,
                        print_signed(ceiling.across),
                        print_signed(ceiling.within),
                        print_signed(ceiling.share),
                        ceiling.splits,
                        ceiling.by_participants ? "participants" : "responses")
          : fmt::format("{} cells; no ceiling", cells.cells));
}

std::optional<double> mean_divergence(const MatrixComparison& cells) {
  if (cells.rows.empty()) return std::nullopt;
  double sum = 0.0;
  for (const auto& one : cells.rows) sum += one.divergence;
  return sum / static_cast<double>(cells.rows.size());
}

std::string row_of_test(const FaceComparison& comparison) {
  const auto& permutation = comparison.permutation;
  const auto design = escaped(design_in_words(comparison));
  if (!permutation.p) return row("Same confusions?", "&#8211;", design);
  return row("Same confusions? Pearson&#8217;s X<sup>2</sup>",
             fmt::format("{:.2f}, {}", permutation.chi_square, italic_p(*permutation.p)),
             fmt::format("{} permutations of {} trials, {} left out. {}",
                         permutation.permutations,
                         permutation.used,
                         permutation.left_out,
                         design));
}

std::string row_of_mantel(const FaceComparison& comparison) {
  const auto& found = comparison.mantel_phi;
  if (!found) return row("Mantel&#8217;s <i>r</i>", "&#8211;", "too few stimuli, or no spread");
  return row("Mantel&#8217;s <i>r</i>",
             fmt::format("{}, {}", print_signed(found->r), italic_p(found->p)),
             fmt::format("of the dissimilarities phi of {} stimuli; {} {}. Whether labels matter "
                         "at all: any two faces pass",
                         found->stimuli,
                         found->permutations,
                         found->enumerated ? "orders, all there are" : "permutations"));
}

std::string table_of(const FaceComparison& comparison) {
  const auto& cells = comparison.cells;
  return fmt::format(
      "<table><caption>{}: {} (first) and {} (second)</caption><thead><tr>"
      "<th scope='col'>Measure</th><th scope='col' class='estimate'>Value</th><th scope='col'>Of "
      "what, and how</th></tr></thead>\n<tbody>{}{}{}{}{}{}{}</tbody></table>\n",
      escaped(comparison.title),
      escaped(comparison.one),
      escaped(comparison.other),
      row_of_correct(comparison),
      row_of_agreement("all", cells.all, comparison.ceiling_all),
      row_of_agreement("off-diagonal", cells.off_diagonal, comparison.ceiling_off_diagonal),
      row("RMS difference",
          fmt::format("{}; off-diagonal {}",
                      print_decimals(cells.all.rms_difference, 3),
                      print_decimals(cells.off_diagonal.rms_difference, 3)),
          fmt::format("{} and {} row proportions", cells.all.cells, cells.off_diagonal.cells)),
      row("Jensen&#8211;Shannon divergence",
          print_decimals(mean_divergence(cells), 3) + " bits",
          fmt::format("mean of {} rows; 0: the same responses, 1: none in common",
                      cells.rows.size())),
      row_of_test(comparison),
      row_of_mantel(comparison));
}

std::string cells_in_words(const FaceComparison& comparison) {
  if (!comparison.permutation.p) return {};
  const auto cells = significant_cells(comparison);
  if (cells.empty()) {
    return "<p>No single cell differs (permutation, false discovery rate .05).</p>\n";
  }
  std::string words;
  for (std::size_t i = 0; i < std::min(cells.size(), kCellsTold); ++i) {
    const auto& cell = cells[i];
    words +=
        fmt::format("{}{} answered {} {} and {} (<i>q</i> = {})",
                    words.empty() ? "" : "; ",
                    escaped(comparison.one_matrix.stimuli()[cell.stimulus]),
                    escaped(comparison.one_matrix.responses()[cell.response]),
                    print_signed(comparison.one_matrix.proportion(cell.stimulus, cell.response)),
                    print_signed(comparison.other_matrix.proportion(cell.stimulus, cell.response)),
                    print_decimals(cell.q, 3));
  }
  return fmt::format(
      "<p><b>Cells that differ</b> (permutation, false discovery rate .05), {}{}: {}.</p>\n",
      cells.size(),
      cells.size() > kCellsTold ? fmt::format(", the {} largest differences first", kCellsTold)
                                : "",
      words);
}

std::string contrasts_in_words(const FaceComparison& comparison) {
  std::string items;
  std::size_t told = 0;
  for (const auto& contrast : comparison.contrasts) {
    if (told == kContrastsTold || contrast.loss() < kLossWorthTelling) break;
    ++told;
    items += fmt::format("<li>{}</li>\n",
                         escaped(contrast_in_words(contrast, comparison.one, comparison.other)));
  }
  if (items.empty()) {
    return fmt::format("<p>{} shows every contrast that {} shows (phi within .05; {} pairs).</p>\n",
                       escaped(comparison.other),
                       escaped(comparison.one),
                       comparison.contrasts.size());
  }
  return fmt::format(
      "<p><b>What {} fails to show</b>, of {} pairs the largest losses first (phi: how unlike two "
      "rows of responses are, 0 to 1):</p>\n<ol>{}</ol>\n",
      escaped(comparison.other),
      comparison.contrasts.size(),
      items);
}

std::string part_of_comparison(const FaceComparison& comparison, int number) {
  return fmt::format(
      "<h3>{}</h3>\n<figure data-unit='{}' data-first='{}' "
      "data-second='{}'>{}<figcaption><b>Figure {}. {}: {} and {}.</b> Row proportions of "
      "each ({} and {} responses), and the first less the second; {}. At the right the number of "
      "presentations.</figcaption></figure>\n{}{}{}",
      escaped(comparison.title),
      comparison.unit ? name(*comparison.unit) : std::string_view{},
      escaped(comparison.one),
      escaped(comparison.other),
      figure_of_comparison(comparison, PaperWidth::TwoColumns),
      number,
      escaped(comparison.title),
      escaped(comparison.one),
      escaped(comparison.other),
      print_count(comparison.cells.n_one),
      print_count(comparison.cells.n_other),
      comparison.permutation.p
          ? "outlined where they differ (permutation, false discovery rate .05)"
          : "differences are not tested",
      table_of(comparison),
      cells_in_words(comparison),
      contrasts_in_words(comparison));
}

std::string words_ratio(const FaceComparison& comparison) {
  return fmt::format(
      "<p>Words correct with {} are {} of those with {} (ratio of proportions, 95 % interval in "
      "brackets; {}). {} participant{} met both.</p>\n",
      escaped(comparison.other),
      print_signed(comparison.ratio, comparison.ratio_interval),
      escaped(comparison.one),
      escaped(comparison.ratio_method),
      comparison.participants,
      comparison.participants == 1 ? "" : "s");
}

}  // namespace

std::string part_of_faces(const Results& results, FigureNumbers& numbers) {
  if (!results.faces) return {};
  std::string part = "<h2 id='faces'>How alike are the two faces?</h2>\n";
  if (results.comparisons.empty()) {
    return part + fmt::format("<p>{} and {} have no unit with responses in both.</p>\n",
                              escaped(results.faces->natural),
                              escaped(results.faces->synthetic));
  }
  part += words_ratio(results.comparisons.front());
  for (const auto& comparison : results.comparisons) {
    part += part_of_comparison(comparison, numbers.next());
  }
  return part;
}

}  // namespace bimodal::analysis

#include "analysis/report/comparison_table.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/report/csv.hpp"
#include "analysis/report/json_count.hpp"
#include "analysis/report/matrix_text.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kListed = 10;     ///< contrasts and cells in the text
constexpr double kWorthTelling = 0.10;  ///< loss of phi

template <typename Value>
Json optional_json(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

/// Two decimals without leading zero, as proportions and correlations are printed.
std::string two_decimals(const std::optional<double>& value) {
  if (!value) return "-";
  auto text = fmt::format("{:.2f}", std::abs(*value));
  if (text.starts_with("0.")) text.erase(0, 1);
  return (*value < 0.0 && text != ".00" ? "-" : "") + text;
}

std::string three_decimals(const std::optional<double>& value) {
  if (!value) return "-";
  auto text = fmt::format("{:.3f}", std::abs(*value));
  if (text.starts_with("0.")) text.erase(0, 1);
  return (*value < 0.0 ? "-" : "") + text;
}

std::string accuracy_lines(const FaceComparison& comparison) {
  const auto& cells = comparison.cells;
  auto text = fmt::format("  n: {} and {} responses; correct {} and {}",
                          print_count(cells.n_one),
                          print_count(cells.n_other),
                          two_decimals(cells.correct_one),
                          two_decimals(cells.correct_other));
  if (cells.accuracy_ratio) text += fmt::format("; ratio {}", two_decimals(cells.accuracy_ratio));
  text += '\n';
  if (comparison.ratio) {
    text += fmt::format("  Words correct, ratio: {}", two_decimals(comparison.ratio));
    if (comparison.ratio_interval) {
      text += fmt::format(" [{}, {}]",
                          two_decimals(comparison.ratio_interval->low),
                          two_decimals(comparison.ratio_interval->high));
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
                     two_decimals(cells.pearson),
                     two_decimals(cells.spearman),
                     three_decimals(cells.rms_difference),
                     two_decimals(ceiling.across),
                     two_decimals(ceiling.within),
                     two_decimals(ceiling.share),
                     two_decimals(ceiling.corrected));
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
                     two_decimals(found->r),
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
                        two_decimals(permutation.accuracy_difference),
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
    text +=
        fmt::format("  {} answered {}: {} and {}, q {}\n",
                    comparison.one_matrix.stimuli()[cell.stimulus],
                    comparison.one_matrix.responses()[cell.response],
                    two_decimals(comparison.one_matrix.proportion(cell.stimulus, cell.response)),
                    two_decimals(comparison.other_matrix.proportion(cell.stimulus, cell.response)),
                    cell.q < 0.001 ? "< .001" : "= " + three_decimals(cell.q));
  }
  return text;
}

std::string contrast_lines(const FaceComparison& comparison) {
  std::string text;
  std::size_t told = 0;
  for (const auto& contrast : comparison.contrasts) {
    if (told == kListed || contrast.loss() < kWorthTelling) break;
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

Json json_of(const CellAgreement& cells) {
  return {{"cells", cells.cells},
          {"pearson", optional_json(cells.pearson)},
          {"spearman", optional_json(cells.spearman)},
          {"rmsd", optional_json(cells.rms_difference)}};
}

Json json_of(const NoiseCeiling& ceiling) {
  return {{"splits", ceiling.splits},
          {"halves_of", ceiling.by_participants ? "participants" : "responses"},
          {"within_halves", optional_json(ceiling.within)},
          {"across_halves", optional_json(ceiling.across)},
          {"share", optional_json(ceiling.share)},
          {"within_full_spearman_brown", optional_json(ceiling.corrected)}};
}

Json json_of(const std::optional<Mantel>& found) {
  if (!found) return {};
  return {{"stimuli", found->stimuli},
          {"r", found->r},
          {"p", found->p},
          {"permutations", found->permutations},
          {"enumerated", found->enumerated}};
}

Json json_of_rows(const MatrixComparison& cells) {
  Json rows = Json::array();
  for (const auto& row : cells.rows) {
    rows.push_back({{"stimulus", row.stimulus},
                    {"n_1", json_count(row.n_one)},
                    {"n_2", json_count(row.n_other)},
                    {"jsd_bits", row.divergence},
                    {"chi_square", row.chi_square},
                    {"df", row.degrees}});
  }
  return rows;
}

Json json_of_permutation(const FaceComparison& comparison) {
  const auto& permutation = comparison.permutation;
  return {{"randomisation",
           comparison.exchanged_responses ? "responses" : name(permutation.randomisation)},
          {"design", design_in_words(comparison)},
          {"permutations", permutation.permutations},
          {"trials_used", permutation.used},
          {"trials_left_out", permutation.left_out},
          {"log10_arrangements", permutation.log10_arrangements},
          {"chi_square", permutation.chi_square},
          {"p", optional_json(permutation.p)},
          {"correct_of", comparison.exchanged_responses ? "responses" : "words"},
          {"correct_difference", permutation.accuracy_difference},
          {"correct_difference_p", optional_json(permutation.accuracy_p)}};
}

Json json_of_cells(const FaceComparison& comparison) {
  Json cells = Json::array();
  const auto& one = comparison.one_matrix;
  const auto& other = comparison.other_matrix;
  for (std::size_t i = 0; i < one.stimuli().size(); ++i) {
    for (std::size_t j = 0; j < one.responses().size(); ++j) {
      const auto cell = i * one.responses().size() + j;
      if (one.count(i, j) + other.count(i, j) <= 0.0) continue;
      cells.push_back({{"stimulus", one.stimuli()[i]},
                       {"response", one.responses()[j]},
                       {"count_1", json_count(one.count(i, j))},
                       {"count_2", json_count(other.count(i, j))},
                       {"proportion_1", optional_json(one.proportion(i, j))},
                       {"proportion_2", optional_json(other.proportion(i, j))},
                       {"p", optional_json(comparison.permutation.cell_p[cell])},
                       {"q", optional_json(comparison.permutation.cell_q[cell])}});
    }
  }
  return cells;
}

Json json_of_contrasts(const FaceComparison& comparison) {
  Json contrasts = Json::array();
  for (const auto& contrast : comparison.contrasts) {
    contrasts.push_back(
        {{"stimulus", contrast.stimulus},
         {"counterpart", contrast.counterpart},
         {"phi_1", contrast.one},
         {"phi_2", contrast.other},
         {"loss", contrast.loss()},
         {"confused_1", contrast.confused_one},
         {"confused_2", contrast.confused_other},
         {"in_words", contrast_in_words(contrast, comparison.one, comparison.other)}});
  }
  return contrasts;
}

std::string in_degrees(double phi) {
  if (phi >= 0.8) return "clearly";
  if (phi >= 0.5) return "fairly";
  if (phi >= 0.25) return "hardly";
  return "not";
}

}  // namespace

std::string print_p(double p) {
  if (p < 0.001) return "p < .001";
  auto text = fmt::format("{:.3f}", p);
  if (text.starts_with("0.")) text.erase(0, 1);
  return "p = " + text;
}

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
      two_decimals(contrast.one),
      two_decimals(contrast.confused_one),
      in_degrees(contrast.other),
      other,
      two_decimals(contrast.other),
      two_decimals(contrast.confused_other));
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

std::string comparison_csv(const FaceComparison& comparison) {
  std::string text;
  std::vector<CsvField> line;
  for (const std::string_view column : {"stimulus",
                                        "response",
                                        "count_1",
                                        "count_2",
                                        "proportion_1",
                                        "proportion_2",
                                        "difference",
                                        "p",
                                        "q"}) {
    line.emplace_back(column);
  }
  append_csv(text, line);
  const auto number = [](const std::optional<double>& value) {
    return value ? CsvField{*value} : CsvField{};
  };
  const auto& one = comparison.one_matrix;
  const auto& other = comparison.other_matrix;
  for (std::size_t i = 0; i < one.stimuli().size(); ++i) {
    for (std::size_t j = 0; j < one.responses().size(); ++j) {
      const auto cell = i * one.responses().size() + j;
      const auto p_one = one.proportion(i, j);
      const auto p_other = other.proportion(i, j);
      line.assign({std::string_view{one.stimuli()[i]},
                   std::string_view{one.responses()[j]},
                   one.count(i, j),
                   other.count(i, j),
                   number(p_one),
                   number(p_other),
                   p_one && p_other ? CsvField{*p_one - *p_other} : CsvField{},
                   number(comparison.permutation.cell_p[cell]),
                   number(comparison.permutation.cell_q[cell])});
      append_csv(text, line);
    }
  }
  return text;
}

std::string comparison_json(const FaceComparison& comparison) {
  const auto& cells = comparison.cells;
  Json json{{"title", comparison.title},
            {"condition_1", comparison.one},
            {"condition_2", comparison.other},
            {"n_1", json_count(cells.n_one)},
            {"n_2", json_count(cells.n_other)},
            {"participants", comparison.participants == 0 ? Json() : Json(comparison.participants)},
            {"correct_1", optional_json(cells.correct_one)},
            {"correct_2", optional_json(cells.correct_other)},
            {"accuracy_ratio", optional_json(cells.accuracy_ratio)},
            {"words_ratio", optional_json(comparison.ratio)},
            {"words_ratio_interval",
             comparison.ratio_interval
                 ? Json{comparison.ratio_interval->low, comparison.ratio_interval->high}
                 : Json()},
            {"words_ratio_method", comparison.ratio_method},
            {"all_cells", json_of(cells.all)},
            {"off_diagonal_cells", json_of(cells.off_diagonal)},
            {"noise_ceiling_all_cells", json_of(comparison.ceiling_all)},
            {"noise_ceiling_off_diagonal_cells", json_of(comparison.ceiling_off_diagonal)},
            {"rows", json_of_rows(cells)},
            {"not_compared", cells.not_compared},
            {"chi_square", cells.chi_square},
            {"df", cells.degrees},
            {"chi_square_p", optional_json(cells.chi_square_p)},
            {"g", cells.g},
            {"mantel_phi", json_of(comparison.mantel_phi)},
            {"mantel_confusion", json_of(comparison.mantel_confusion)},
            {"permutation", json_of_permutation(comparison)}};
  json["cells"] = json_of_cells(comparison);
  json["contrasts"] = json_of_contrasts(comparison);
  return json.dump(2) + "\n";
}

}  // namespace bimodal::analysis

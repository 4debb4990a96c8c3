#include "analysis/report/comparison_table.hpp"

#include <nlohmann/json.hpp>

#include "analysis/report/csv.hpp"
#include "analysis/report/json_count.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

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
                   csv_number(p_one),
                   csv_number(p_other),
                   p_one && p_other ? CsvField{*p_one - *p_other} : CsvField{},
                   csv_number(comparison.permutation.cell_p[cell]),
                   csv_number(comparison.permutation.cell_q[cell])});
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
            {"words_ratio_interval", interval_json(comparison.ratio_interval)},
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

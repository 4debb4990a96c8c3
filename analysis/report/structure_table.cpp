#include "analysis/report/structure_table.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "analysis/report/csv.hpp"
#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::ordered_json;

/// What each cluster consists of, in words: "p", "p t", ...
std::vector<std::string> cluster_names(const ClusterTable& table) {
  auto names = table.labels;
  for (const auto& merge : table.merges) {
    names.push_back(names.at(merge.one) + " " + names.at(merge.other));
  }
  return names;
}

double at(const LayoutTable& table, std::size_t thing, std::size_t dimension) {
  return table.layout.coordinates[thing * table.layout.dimensions + dimension];
}

std::string lexicon_text(const LexicalEquivalence& lexicon) {
  return fmt::format(
      "\nThe lexicon, if phones of one class look the same: {} words in {} classes of words that\n"
      "look the same; {} words ({} %) alone in theirs (by sound {}); expected class size "
      "{:.2f};\n"
      "{:.1f} % of the words' information extracted (every word as likely as any other).\n",
      lexicon.words,
      lexicon.classes,
      lexicon.unique,
      print_percent(lexicon.unique_share),
      lexicon.unique_by_sound,
      lexicon.expected_size,
      100.0 * lexicon.extracted);
}

Json lexicon_json(const LexicalEquivalence& lexicon) {
  return {{"words", lexicon.words},
          {"classes", lexicon.classes},
          {"unique", lexicon.unique},
          {"unique_share", lexicon.unique_share},
          {"unique_by_sound", lexicon.unique_by_sound},
          {"expected_class_size", lexicon.expected_size},
          {"information_extracted", lexicon.extracted}};
}

}  // namespace

std::string_view name(DissimilarityMeasure measure) {
  return measure == DissimilarityMeasure::Phi ? "phi" : "confusion";
}

std::string_view name(Linkage linkage) {
  switch (linkage) {
    case Linkage::Single:
      return "single";
    case Linkage::Complete:
      return "complete";
    case Linkage::Average:
      break;
  }
  return "average";
}

ClusterTable tabulate_clusters(std::string title,
                               const ConfusionMatrix& matrix,
                               DissimilarityMeasure measure,
                               Linkage linkage,
                               double criterion) {
  const auto unlike = dissimilarities(matrix, measure);
  ClusterTable table{.title = std::move(title),
                     .measure = measure,
                     .linkage = linkage,
                     .criterion = criterion,
                     .labels = unlike.labels(),
                     .merges = cluster(unlike, linkage),
                     .order = {},
                     .classes = {}};
  for (const auto leaf : leaf_order(table.merges)) table.order.push_back(table.labels.at(leaf));
  const auto count = merges_until_kept(matrix, table.labels, table.merges, criterion);
  for (const auto& members : classes_after(table.merges, count)) {
    auto& made = table.classes.emplace_back();
    for (const auto member : members) made.members.push_back(table.labels[member]);
    made.kept = kept_within(matrix, made.members);
  }
  for (const double usual : {0.70, 0.75, 0.80}) {
    const auto merges = merges_until_kept(matrix, table.labels, table.merges, usual);
    table.cuts.push_back({usual, classes_after(table.merges, merges).size()});
  }
  return table;
}

std::string cluster_text(const ClusterTable& table) {
  auto text = fmt::format("{}: {} linkage of dissimilarities by {}\n\n",
                          table.title,
                          name(table.linkage),
                          name(table.measure));
  const auto names = cluster_names(table);
  for (const auto& merge : table.merges) {
    text += fmt::format("  {:.3f}  {} + {}\n", merge.height, names[merge.one], names[merge.other]);
  }
  text += fmt::format("\norder of a dendrogram: {}\n", fmt::join(table.order, " "));
  const bool met = std::ranges::all_of(
      table.classes, [&](const ClusterTable::Class& one) { return one.kept >= table.criterion; });
  text += fmt::format(
      "\n{} class{} after the fewest merges by which each keeps at least {:g} of the "
      "responses to its members{}:\n",
      table.classes.size(),
      table.classes.size() == 1 ? "" : "es",
      table.criterion,
      met ? "" : " (none does)");
  for (const auto& made : table.classes) {
    text += fmt::format("  /{}/  {:.3f}\n", fmt::join(made.members, " "), made.kept);
  }
  text += "classes at other criteria:";
  for (const auto& cut : table.cuts)
    text += fmt::format(" {} at {:.2f}", cut.classes, cut.criterion);
  return text + '\n' + (table.lexicon ? lexicon_text(*table.lexicon) : std::string{});
}

std::string cluster_csv(const ClusterTable& table) {
  std::string text;
  append_csv(text,
             std::vector<CsvField>{std::string_view{"class"},
                                   std::string_view{"label"},
                                   std::string_view{"kept_within_class"}});
  for (std::size_t i = 0; i < table.classes.size(); ++i) {
    for (const auto& member : table.classes[i].members) {
      append_csv(
          text,
          std::vector<CsvField>{
              static_cast<std::int64_t>(i + 1), std::string_view{member}, table.classes[i].kept});
    }
  }
  return text;
}

std::string cluster_json(const ClusterTable& table) {
  Json json{{"title", table.title},
            {"measure", name(table.measure)},
            {"linkage", name(table.linkage)},
            {"criterion", table.criterion},
            {"labels", table.labels},
            {"order", table.order},
            {"merges", Json::array()},
            {"classes", Json::array()}};
  for (const auto& merge : table.merges) {
    json["merges"].push_back({{"one", merge.one},
                              {"other", merge.other},
                              {"height", merge.height},
                              {"members", merge.members}});
  }
  for (const auto& made : table.classes) {
    json["classes"].push_back({{"members", made.members}, {"kept", made.kept}});
  }
  for (const auto& cut : table.cuts) {
    json["classes_at"].push_back({{"criterion", cut.criterion}, {"classes", cut.classes}});
  }
  if (table.lexicon) json["lexicon"] = lexicon_json(*table.lexicon);
  return json.dump(2) + "\n";
}

std::string layout_text(const LayoutTable& table) {
  auto text = fmt::format(
      "{}: classical multidimensional scaling of dissimilarities by {}\nstress-1 {:.3f}; {:.1f} % "
      "of "
      "the sum of the positive eigenvalues\n\n",
      table.title,
      name(table.measure),
      table.layout.stress,
      100.0 * table.layout.share);
  for (std::size_t i = 0; i < table.labels.size(); ++i) {
    text += fmt::format("  {:<8}", table.labels[i]);
    for (std::size_t k = 0; k < table.layout.dimensions; ++k) {
      text += fmt::format("{:>9.3f}", at(table, i, k));
    }
    text += '\n';
  }
  return text;
}

std::string layout_csv(const LayoutTable& table) {
  std::string text = "\"label\"";
  for (std::size_t k = 1; k <= table.layout.dimensions; ++k) {
    text += fmt::format(",\"dimension_{}\"", k);
  }
  text += '\n';
  for (std::size_t i = 0; i < table.labels.size(); ++i) {
    std::vector<CsvField> line{std::string_view{table.labels[i]}};
    for (std::size_t k = 0; k < table.layout.dimensions; ++k) line.emplace_back(at(table, i, k));
    append_csv(text, line);
  }
  return text;
}

std::string layout_json(const LayoutTable& table) {
  Json json{{"title", table.title},
            {"measure", name(table.measure)},
            {"stress_1", table.layout.stress},
            {"share_of_positive_eigenvalues", table.layout.share},
            {"eigenvalues", table.layout.eigenvalues},
            {"points", Json::array()}};
  for (std::size_t i = 0; i < table.labels.size(); ++i) {
    Json place = Json::array();
    for (std::size_t k = 0; k < table.layout.dimensions; ++k) place.push_back(at(table, i, k));
    json["points"].push_back({{"label", table.labels[i]}, {"at", std::move(place)}});
  }
  return json.dump(2) + "\n";
}

}  // namespace bimodal::analysis

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/scoring/lexical_equivalence.hpp"
#include "analysis/statistics/clustering.hpp"
#include "analysis/statistics/scaling.hpp"

namespace bimodal::analysis {

/// Which stimuli are alike, and the classes into which they fall.
struct ClusterTable {
  std::string title;
  DissimilarityMeasure measure = DissimilarityMeasure::Phi;
  Linkage linkage = Linkage::Average;
  double criterion = 0.75;
  std::vector<std::string> labels;  ///< of the stimuli that were presented
  std::vector<Merge> merges;
  std::vector<std::string> order;  ///< labels, as a dendrogram draws them

  struct Class {
    std::vector<std::string> members;
    double kept = 0.0;  ///< the part of the responses to its members that names a member
  };

  std::vector<Class> classes;  ///< by the criterion

  /// How many classes the usual criteria give, .70, .75 and .80.
  struct Cut {
    double criterion = 0.0;
    std::size_t classes = 0;
  };

  std::vector<Cut> cuts;
  std::optional<LexicalEquivalence> lexicon;  ///< by these classes; absent: not wanted
};

/// "phi", "confusion"; "single", "complete", "average".
[[nodiscard]] std::string_view name(DissimilarityMeasure measure);
[[nodiscard]] std::string_view name(Linkage linkage);

[[nodiscard]] ClusterTable tabulate_clusters(std::string title,
                                             const ConfusionMatrix& matrix,
                                             DissimilarityMeasure measure,
                                             Linkage linkage,
                                             double criterion);

[[nodiscard]] std::string cluster_text(const ClusterTable& table);
[[nodiscard]] std::string cluster_csv(const ClusterTable& table);
[[nodiscard]] std::string cluster_json(const ClusterTable& table);

/// Where the stimuli lie if alike ones lie near each other.
struct LayoutTable {
  std::string title;
  DissimilarityMeasure measure = DissimilarityMeasure::Phi;
  std::vector<std::string> labels;
  Layout layout;
};

[[nodiscard]] std::string layout_text(const LayoutTable& table);
[[nodiscard]] std::string layout_csv(const LayoutTable& table);
[[nodiscard]] std::string layout_json(const LayoutTable& table);

}  // namespace bimodal::analysis

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/report/figures/svg.hpp"
#include "analysis/report/results.hpp"
#include "analysis/report/structure_table.hpp"

namespace bimodal::analysis {

/// Proportion of correct words in each condition: the pooled value with its interval, and a dot for
/// every participant.
[[nodiscard]] std::string figure_of_words(const Results& results, PaperWidth width);

/// A confusion matrix by place of articulation.
[[nodiscard]] std::string figure_of_confusions(const UnitConfusions& confusions, PaperWidth width);

/// What the classes of the report keep at least of the responses to their members.
inline constexpr double kKeptByClasses = 0.75;

/// Whether so many phones were presented (three) that it can be told which are alike.
[[nodiscard]] bool has_structure(const UnitConfusions& confusions);

/// Classes by average linkage of dissimilarities by phi, and the layout by these.
[[nodiscard]] ClusterTable clusters_of(const UnitConfusions& confusions);
[[nodiscard]] LayoutTable layout_of(const UnitConfusions& confusions);

/// The same, drawn.
[[nodiscard]] std::string figure_of_clusters(const UnitConfusions& confusions, PaperWidth width);
[[nodiscard]] std::string figure_of_layout(const UnitConfusions& confusions, PaperWidth width);

/// Two faces side by side, and their difference with the cells that differ outlined.
[[nodiscard]] std::string figure_of_comparison(const FaceComparison& comparison, PaperWidth width);

/// The voice-alone conditions to which some condition adds a face, in the benefits' order.
[[nodiscard]] std::vector<std::string> voices_with_faces(const Results& results);

/// The benefit of every face that is added to one voice-alone condition: a mark a participant.
[[nodiscard]] std::string figure_of_benefits(const Results& results,
                                             const std::string& auditory,
                                             PaperWidth width);

/// How much of voicing, place and manner came through, for one unit in all its conditions.
[[nodiscard]] std::string figure_of_features(const Results& results, Unit unit, PaperWidth width);

/// One of the report's figures, to be drawn at any width; borrows the results.
struct ReportFigure {
  std::string name;  ///< as its files are named, without extension
  std::function<std::string(PaperWidth)> draw;
};

/// All figures that become files of their own: words, benefits, the two faces, features, and every
/// confusion matrix with its dendrogram and layout.
[[nodiscard]] std::vector<ReportFigure> report_figures(const Results& results);

}  // namespace bimodal::analysis

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/report/page_parts.hpp"
#include "analysis/report/printed_number.hpp"
#include "analysis/report/report_figures.hpp"
#include "stimuli/base/markup.hpp"

namespace bimodal::analysis {

namespace {

std::string classes_in_words(const ClusterTable& table) {
  std::string text;
  for (const auto& made : table.classes) {
    text += fmt::format("{}/\u2060{}/ {}",  // kept together with its first phone
                        text.empty() ? "" : ", ",
                        escaped(fmt::format("{}", fmt::join(made.members, " "))),
                        print_proportion(made.kept));
  }
  return text;
}

std::string figure_of_structure(const UnitConfusions& confusions, int number) {
  const auto clusters = clusters_of(confusions);
  return fmt::format(
      "<figure><div class='side'>{}{}</div><figcaption><b>Figure {}. {}, condition {}.</b> "
      "Dendrogram and layout (stress-1 {:.3f}) of {} phones by {:.0f} responses. Classes and "
      "the part of the responses that each keeps: {}.</figcaption></figure>\n",
      figure_of_clusters(confusions, PaperWidth::OneColumn),
      figure_of_layout(confusions, PaperWidth::OneColumn),
      number,
      title(confusions.unit),
      escaped(confusions.condition),
      layout_of(confusions).layout.stress,
      clusters.labels.size(),
      confusions.matrix.total(),
      classes_in_words(clusters));
}

}  // namespace

std::string part_of_structure(const Results& results, FigureNumbers& numbers) {
  std::string part;
  for (const auto& table : results.confusions) {
    if (has_structure(table)) part += figure_of_structure(table, numbers.next());
  }
  if (part.empty()) return {};
  return fmt::format(
      "<h2 id='structure'>Which phones are alike</h2>\n<p>Two phones are the less alike, the less "
      "alike their rows of responses are (the square root of phi-square: Iverson, Bernstein &amp; "
      "Auer, 1998, <i>Speech Communication 26</i>, 45&#8211;63); clusters are joined by average "
      "linkage, and laid out in the plane by classical scaling. The dashed line cuts the "
      "dendrogram after the fewest merges by which every class keeps at least {} of the responses "
      "to its members (after Walden et al., 1977, <i>Journal of Speech and Hearing Research "
      "20</i>, 130&#8211;145): visemes, where nothing was heard.</p>\n{}",
      print_proportion(kKeptByClasses),
      part);
}

}  // namespace bimodal::analysis

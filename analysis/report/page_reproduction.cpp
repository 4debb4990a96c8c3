#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/report/comparison_table.hpp"
#include "analysis/report/page_parts.hpp"
#include "stimuli/base/markup.hpp"

namespace bimodal::analysis {

namespace {

std::string row(std::string_view what, std::string_view value, std::string_view kind = {}) {
  return fmt::format("<tr><th scope='row'>{}</th><td{}>{}</td></tr>\n",
                     what,
                     kind.empty() ? std::string{} : fmt::format(" class='{}'", kind),
                     value);
}

std::string resamples_in_words(const Results& results) {
  auto words = fmt::format("{} bootstrap draws", results.bootstrap.draws);
  if (!results.faces) return words;
  return words + fmt::format("; {} permutations, {} splits into halves",
                             results.comparison.permutations,
                             results.comparison.splits);
}

/// "12 practice trial, 3 response time"; only what left out any.
std::string exclusions_in_words(const Dataset& dataset) {
  std::string words;
  for (const auto& [reason, trials] : dataset.exclusions) {
    if (trials == 0) continue;
    words += fmt::format("{}{} &#215; {}", words.empty() ? "" : ", ", trials, escaped(reason));
  }
  return words.empty() ? "nothing was left out" : "left out: " + words;
}

std::size_t words_presented(const Dataset& dataset) {
  std::set<std::string_view> words;
  for (const auto& trial : dataset.trials) words.insert(trial.word);
  return words.size();
}

std::string paragraph_on_answers(const Results& results, const Making& making) {
  const auto& dataset = results.dataset;
  std::vector<std::string> names;
  for (const auto& condition : results.conditions) names.push_back(escaped(condition.name));
  return fmt::format(
      "{} participant{} gave {} answers to {} different words in {} condition{} ({}); of {} stored "
      "trials {}. Answers were scored by {}. {} ",
      results.participants.size(),
      results.participants.size() == 1 ? "" : "s",
      dataset.trials.size(),
      words_presented(dataset),
      names.size(),
      names.size() == 1 ? "" : "s",
      fmt::join(names, ", "),
      dataset.stored_trials,
      exclusions_in_words(dataset),
      escaped(making.program),
      escaped(describe_rules(results.rules)));
}

std::string paragraph_on_intervals(const Results& results) {
  if (results.participants.size() == 1) {
    return "Intervals are Wilson&#8217;s (1927), 95 %, and of phonemes those of a bootstrap over "
           "words; they speak of this participant only. ";
  }
  return fmt::format(
      "Intervals of pooled proportions are 95 % percentile intervals of a bootstrap that draws "
      "participants and words anew, independently ({} draws; Owen, 2007); those of one participant "
      "are Wilson&#8217;s (1927), and of phonemes those of a bootstrap over words. ",
      results.bootstrap.draws);
}

std::string paragraph_on_faces(const Results& results) {
  if (results.comparisons.empty()) return {};
  const auto& first = results.comparisons.front();
  auto text = fmt::format(
      "The confusions of {} and {} were compared by the correlation of their cells, against that "
      "of halves of {} with each other ({} splits), and by Jensen&#8211;Shannon divergence (Lin, "
      "1991). ",
      escaped(first.one),
      escaped(first.other),
      escaped(first.one),
      results.comparison.splits);
  if (!first.permutation.p) return text + escaped(design_in_words(first)) + " ";
  text += fmt::format(
      "Whether they differ was tested by Pearson&#8217;s X<sup>2</sup> with {} permutations "
      "(Edgington &amp; Onghena, 2007). {} Cells are said to differ at a false discovery rate of "
      ".05 (Benjamini &amp; Hochberg, 1995). ",
      first.permutation.permutations,
      escaped(design_in_words(first)));
  for (const auto& comparison : results.comparisons) {
    text += fmt::format("{}: {} trials, {} left out. ",
                        escaped(comparison.title),
                        comparison.permutation.used,
                        comparison.permutation.left_out);
  }
  return text;
}

std::string references_of(const Results& results) {
  std::vector<std::string> references;
  const bool faces = !results.comparisons.empty();
  const bool tested = faces && results.comparisons.front().permutation.p.has_value();
  if (tested) {
    references.emplace_back(
        "Benjamini, Y., &amp; Hochberg, Y. (1995). Controlling the false discovery rate. "
        "<i>Journal of the Royal Statistical Society B, 57</i>, 289&#8211;300.");
    references.emplace_back(
        "Edgington, E. S., &amp; Onghena, P. (2007). <i>Randomization tests</i> (4th ed.).");
  }
  if (faces) {
    references.emplace_back(
        "Lin, J. (1991). Divergence measures based on the Shannon entropy. <i>IEEE Transactions on "
        "Information Theory, 37</i>, 145&#8211;151.");
  }
  if (!results.features.empty()) {
    references.emplace_back(
        "Miller, G. A., &amp; Nicely, P. E. (1955). An analysis of perceptual confusions among "
        "some English consonants. <i>Journal of the Acoustical Society of America, 27</i>, "
        "338&#8211;352.");
  }
  if (results.participants.size() > 1) {
    references.emplace_back(
        "Owen, A. B. (2007). The pigeonhole bootstrap. <i>Annals of Applied Statistics, 1</i>, "
        "386&#8211;411.");
  }
  if (!results.benefits.empty()) {
    references.emplace_back(
        "Sumby, W. H., &amp; Pollack, I. (1954). Visual contribution to speech intelligibility in "
        "noise. <i>Journal of the Acoustical Society of America, 26</i>, 212&#8211;215.");
  }
  references.emplace_back(
      "Wilson, E. B. (1927). Probable inference, the law of succession, and statistical inference. "
      "<i>Journal of the American Statistical Association, 22</i>, 209&#8211;212.");
  std::string text;
  for (const auto& reference : references) text += "<li>" + reference + "</li>\n";
  return text;
}

}  // namespace

std::string part_for_paper(const Results& results, const Making& making) {
  auto text = paragraph_on_answers(results, making) + paragraph_on_intervals(results) +
              paragraph_on_faces(results);
  if (!results.benefits.empty()) {
    text +=
        "The benefit of the face is AV &#8722; A, and relative to what could be gained (AV &#8722; "
        "A) / (1 &#8722; A) (Sumby &amp; Pollack, 1954). ";
  }
  if (!results.features.empty()) {
    text +=
        "Transmitted information of voicing, place and manner of consonants is after Miller and "
        "Nicely (1955), as observed and corrected by Miller and Madow&#8217;s formula. ";
  }
  return fmt::format(
      "<h2 id='paper'>To copy into a paper</h2>\n<p>{}</p>\n<h3>References</h3>\n<ul>{}</ul>\n",
      text,
      references_of(results));
}

std::string part_of_reproduction(const Results& results, const Making& making) {
  std::string rows = row("Program", escaped(making.program));
  if (!making.command.empty()) rows += row("Command", escaped(making.command), "command");
  rows += row("Seed", fmt::format("{}", results.bootstrap.seed));
  rows += row("Resamples", resamples_in_words(results));
  rows += row("Scoring", escaped(describe_rules(results.rules)));
  rows += row("Trials",
              fmt::format("{} stored, {} analysed; {}",
                          results.dataset.stored_trials,
                          results.dataset.trials.size(),
                          exclusions_in_words(results.dataset)));
  for (std::size_t i = 0; i < results.dataset.files.size(); ++i) {
    const auto& file = results.dataset.files[i];
    rows += row(fmt::format("Data file {}", i + 1), escaped(file.name));
    rows += row("SHA-256", escaped(file.sha256), "hash");
  }
  rows += row("Dictionary or lexicon", escaped(results.dictionary.file));
  rows += row("SHA-256", escaped(results.dictionary.sha256), "hash");
  return fmt::format(
      "<h2 id='reproduction'>To make it again</h2>\n<div class='reproduction'><table><tbody>{}"
      "</tbody></table></div>\n",
      rows);
}

}  // namespace bimodal::analysis

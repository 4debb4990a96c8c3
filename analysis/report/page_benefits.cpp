#include <cmath>

#include <fmt/format.h>

#include "analysis/report/page_parts.hpp"
#include "analysis/report/printed_number.hpp"
#include "analysis/report/report_figures.hpp"
#include "stimuli/base/markup.hpp"

namespace bimodal::analysis {

namespace {

std::string with_trials(const std::optional<double>& proportion, std::int64_t trials) {
  if (!proportion) return "&#8211;";
  return fmt::format("{} <span class='note'>{}</span>", print_proportion(*proportion), trials);
}

std::string log_odds(const std::optional<double>& value) {
  if (!value) return "&#8211;";
  return fmt::format("{}{:.2f}", *value < 0.0 ? "&#8722;" : "", std::abs(*value));
}

std::string rows_of_benefits(const Results& results) {
  std::string rows;
  for (const auto& row : results.benefits) {
    rows += fmt::format(
        "<tr><th scope='row'>{}</th><td>{}</td><td class='estimate'>{}</td><td "
        "class='estimate'>{}</td><td class='estimate'>{}</td><td class='estimate'>{}</td><td "
        "class='estimate'>{}</td><td class='number'>{}</td><td class='number'>{}</td></tr>\n",
        escaped(row.bimodal),
        escaped(row.visual.empty() ? row.auditory : row.auditory + "; " + row.visual),
        with_trials(row.a, row.n_auditory),
        with_trials(row.v, row.n_visual),
        with_trials(row.av, row.n),
        print_signed(row.benefit.gain, row.gain_interval),
        print_signed(row.benefit.relative, row.relative_interval),
        log_odds(row.benefit.log_odds),
        print_signed(row.benefit.excess));
  }
  return rows;
}

std::string methods_of(const Results& results) {
  std::string words;
  for (const auto& row : results.benefits) {
    words += fmt::format(
        "{}{}: {}", words.empty() ? "" : "; ", escaped(row.bimodal), escaped(row.method));
  }
  return words;
}

std::string shares_in_words(const Results& results) {
  std::string words;
  for (const auto& row : results.shares) {
    words += fmt::format(
        "<p>Of the benefit of {}, {} gives the part {} ((AV<sub>syn</sub> &#8722; A) / "
        "(AV<sub>nat</sub> &#8722; A); voice alone: {}; {}).</p>\n",
        escaped(row.natural),
        escaped(row.synthetic),
        print_signed(row.share, row.interval),
        escaped(row.auditory),
        escaped(row.method));
  }
  return words;
}

std::string rows_of_features(const Results& results, Unit unit) {
  std::string rows;
  for (const auto& table : results.features) {
    if (table.unit != unit) continue;
    bool first = true;
    for (const auto& feature : table.information.features) {
      const auto& found = feature.information;
      const auto bits = [&](double value) {
        return fmt::format("{}{:.3f}", value < 0.0 ? "&#8722;" : "", std::abs(value));
      };
      rows +=
          fmt::format("<tr{}>{}<td>{}</td>",
                      first ? " class='first'" : "",
                      first ? "<th scope='row'>" + escaped(table.condition) + "</th>" : "<td></td>",
                      escaped(feature.feature));
      first = false;
      if (!found) {
        rows +=
            "<td class='number'>&#8211;</td><td class='number'>&#8211;</td>"
            "<td class='number'>&#8211;</td><td class='number'>&#8211;</td>"
            "<td class='number'>0</td>";
      } else {
        rows += fmt::format(
            "<td class='number'>{}</td><td class='number'>{}</td><td class='number'>{}</td>"
            "<td class='number'>{}</td><td class='number'>{}</td>",
            bits(found->stimulus_entropy),
            bits(found->transmitted),
            print_signed(found->relative),
            found->relative ? print_signed(found->miller_madow / found->stimulus_entropy)
                            : "&#8211;",
            print_count(found->responses));
      }
      rows += fmt::format("<td class='number'>{}</td></tr>\n", print_count(feature.left_out));
    }
  }
  return rows;
}

}  // namespace

std::string part_of_benefits(const Results& results, FigureNumbers& numbers) {
  if (results.benefits.empty()) return {};
  std::string part = "<h2 id='benefit'>What the face adds to the voice</h2>\n";
  for (const auto& voice : voices_with_faces(results)) {
    part += fmt::format(
        "<figure class='column'>{}<figcaption><b>Figure {}.</b> Benefit AV &#8722; A in words "
        "correct against A, "
        "the voice alone ({}): a mark for each participant in each bimodal condition, "
        "participants with trials in both.</figcaption></figure>\n",
        figure_of_benefits(results, voice, PaperWidth::OneColumn),
        numbers.next(),
        escaped(voice));
  }
  return part +
         fmt::format(
             "<table><caption>Words correct with voice alone, face alone and both</caption><thead>"
             "<tr><th scope='col'>Both</th><th scope='col'>Alone: voice; face</th>"
             "<th scope='col' class='estimate'>A <span class='note'>trials</span></th>"
             "<th scope='col' class='estimate'>V</th><th scope='col' class='estimate'>AV</th>"
             "<th scope='col' class='estimate'>AV &#8722; A</th>"
             "<th scope='col' class='estimate'>(AV &#8722; A) / (1 &#8722; A)</th>"
             "<th scope='col' class='number'>Log odds</th><th scope='col' class='number'>Excess"
             "</th></tr></thead>\n<tbody>{}</tbody></table>\n{}<p class='note'>All trials of a "
             "condition pooled [95 % interval, the same participants and words drawn for all "
             "conditions of a row: {}]. (AV &#8722; A) / (1 &#8722; A): of what could be gained "
             "(Sumby &amp; Pollack, 1954, <i>Journal of the Acoustical Society of America 26</i>, "
             "212&#8211;215). Log odds: logit AV &#8722; logit A. Excess: above probability "
             "summation, A + V &#8722; A V.</p>\n",
             rows_of_benefits(results),
             shares_in_words(results),
             methods_of(results));
}

std::string part_of_features(const Results& results, FigureNumbers& numbers) {
  if (results.features.empty()) return {};
  std::string part =
      "<h2 id='features'>Which features of consonants came through</h2>\n<p>Transmitted "
      "information of voicing, place and manner (Miller &amp; Nicely, 1955, <i>Journal of the "
      "Acoustical Society of America 27</i>, 338&#8211;352), as a part of what the stimuli had, "
      "T / H. As observed it is too large, the more so the fewer the responses; Miller and "
      "Madow&#8217;s formula corrects too little. No interval: responses of one participant are "
      "not independent.</p>\n";
  for (const Unit unit : {Unit::ConsonantInitial, Unit::ConsonantFinal}) {
    const auto rows = rows_of_features(results, unit);
    if (rows.empty()) continue;
    part += fmt::format(
        "<h3>{0}</h3>\n<figure>{1}<figcaption><b>Figure {2}. {0}.</b> T / H: filled, corrected by "
        "Miller and Madow&#8217;s formula; outlined, as observed.</figcaption></figure>\n"
        "<table><caption>{0}: information in bits per response</caption><thead><tr>"
        "<th scope='col'>Condition</th><th scope='col'>Feature</th>"
        "<th scope='col' class='number'>H</th><th scope='col' class='number'>T</th>"
        "<th scope='col' class='number'>T / H</th><th scope='col' class='number'>Corrected</th>"
        "<th scope='col' class='number'><i>n</i></th><th scope='col' class='number'>Left out</th>"
        "</tr></thead>\n<tbody>{3}</tbody></table>\n<p class='note'>Left out: responses deleted, "
        "blank or other.</p>\n",
        title(unit),
        figure_of_features(results, unit, PaperWidth::TwoColumns),
        numbers.next(),
        rows);
  }
  return part;
}

}  // namespace bimodal::analysis

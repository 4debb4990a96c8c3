#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/report/page_parts.hpp"
#include "analysis/report/printed_number.hpp"
#include "analysis/report/report_figures.hpp"
#include "stimuli/base/markup.hpp"

namespace bimodal::analysis {

namespace {

std::string title_of(Measure measure) {
  switch (measure) {
    case Measure::Word:
      return "Words";
    case Measure::Phoneme:
      return "Phonemes";
    case Measure::ConsonantInitial:
      return "Initial consonants";
    case Measure::Vowel:
      return "Vowels";
    case Measure::ConsonantFinal:
      return "Final consonants";
  }
  return {};
}

/// Only where a rule of tolerance accepts anything.
bool shows_tolerated(const Results& results) {
  return std::ranges::any_of(results.conditions,
                             [](const ConditionSummary& one) { return one.tolerated > 0; });
}

std::string rows_of_answers(const Results& results) {
  const bool tolerated = shows_tolerated(results);
  std::string rows;
  for (const auto& condition : results.conditions) {
    rows += fmt::format(
        "<tr><td><b>{}</b></td><td>{}</td><td class='number'>{}</td><td class='number'>{}</td>"
        "<td class='number'>{}</td><td class='number'>{}</td>{}<td class='number'>{}</td>"
        "<td class='number'>{}</td><td class='number'>{}</td></tr>\n",
        escaped(condition.name),
        escaped(condition.meaning),
        condition.participants,
        condition.trials,
        condition.correct,
        condition.homophones,
        tolerated ? fmt::format("<td class='number'>{}</td>", condition.tolerated) : "",
        condition.wrong,
        condition.unknown,
        condition.omissions);
  }
  return rows;
}

std::string rows_of_pooled(const Results& results) {
  std::string rows;
  for (const Measure measure : kMeasures) {
    bool first = true;
    for (const auto& pooled : results.pooled) {
      if (pooled.measure != measure) continue;
      rows += fmt::format(
          "<tr{}><td>{}</td><td>{}</td><td class='number'>{} / {}</td>"
          "<td class='estimate'>{}</td><td class='note'>{}</td></tr>\n",
          first ? " class='first'" : "",
          first ? title_of(measure) : "",
          escaped(pooled.condition),
          pooled.correct,
          pooled.judged,
          print_estimate(pooled),
          escaped(pooled.method));
      first = false;
    }
  }
  return rows;
}

const Proportion* find_own(const Results& results,
                           const std::string& participant,
                           const std::string& condition,
                           Measure measure) {
  const auto found = std::ranges::find_if(results.individual, [&](const Proportion& own) {
    return own.participant == participant && own.condition == condition && own.measure == measure;
  });
  return found == results.individual.end() ? nullptr : &*found;
}

std::string rows_of_individuals(const Results& results, Measure measure) {
  std::string rows;
  for (const auto& participant : results.participants) {
    rows += fmt::format("<tr><td>{}</td>", escaped(participant));
    for (const auto& condition : results.conditions) {
      const auto* const own = find_own(results, participant, condition.name, measure);
      rows += own == nullptr ? std::string{"<td class='estimate'>&#8211;</td>"}
                             : fmt::format(
                                   "<td class='estimate'>{} <span class='note'>{}/{}"
                                   "</span></td>",
                                   print_estimate(*own),
                                   own->correct,
                                   own->judged);
    }
    rows += "</tr>\n";
  }
  return rows;
}

std::string table_of_individuals(const Results& results,
                                 Measure measure,
                                 std::string_view interval) {
  std::string heads;
  for (const auto& condition : results.conditions) {
    heads += fmt::format("<th scope='col' class='estimate'>{}</th>", escaped(condition.name));
  }
  return fmt::format(
      "<h3>{}, each participant</h3>\n<table><thead><tr><th "
      "scope='col'>Participant</th>{}</tr></thead>\n"
      "<tbody>{}</tbody></table>\n<p class='note'>Proportion correct [95 % interval: {}] and "
      "counts.</p>\n",
      title_of(measure),
      heads,
      rows_of_individuals(results, measure),
      interval);
}

}  // namespace

std::string print_estimate(const Proportion& proportion) {
  if (!proportion.proportion) return "&#8211;";
  auto text = print_proportion(*proportion.proportion);
  if (proportion.interval) {
    text += fmt::format(" [{}, {}]",
                        print_proportion(proportion.interval->low),
                        print_proportion(proportion.interval->high));
  }
  return text;
}

std::string print_signed(const std::optional<double>& value) {
  if (!value) return "&#8211;";
  const auto text = print_proportion(std::abs(*value));
  return (*value < 0 && text != ".00" ? "&#8722;" : "") + text;
}

std::string print_signed(const std::optional<double>& value,
                         const std::optional<Interval>& interval) {
  auto text = print_signed(value);
  if (value && interval) {
    text += fmt::format(" [{}, {}]", print_signed(interval->low), print_signed(interval->high));
  }
  return text;
}

std::string part_of_words(const Results& results, FigureNumbers& numbers) {
  const bool tolerated = shows_tolerated(results);
  return fmt::format(
      "<h2 id='words'>Words correct</h2>\n<figure>{}<figcaption><b>Figure {}.</b> Proportion of "
      "words identified correctly. Bar and number: all trials of the condition pooled, with its "
      "95 % interval (methods in the table of proportions); dots: participants.</figcaption>"
      "</figure>\n<h3>What was answered</h3>\n<table><thead><tr><th scope='col'>Condition</th>"
      "<th scope='col'>Presented</th><th scope='col' class='number'>Participants</th><th "
      "scope='col' class='number'>Trials</th>"
      "<th scope='col' class='number'>Correct</th><th scope='col' class='number'>Homophone</th>{}"
      "<th scope='col' class='number'>Wrong word</th><th scope='col' class='number'>Not in "
      "dictionary</th>"
      "<th scope='col' class='number'>Blank</th></tr></thead>\n<tbody>{}</tbody></table>\n"
      "<p class='note'>Each trial is in one of the last {} columns. Correct words are the "
      "first "
      "{} of them.</p>\n",
      figure_of_words(results, PaperWidth::TwoColumns),
      numbers.next(),
      tolerated ? "<th scope='col' class='number'>Tolerated</th>" : "",
      rows_of_answers(results),
      tolerated ? "six" : "five",
      tolerated ? "three" : "two");
}

std::string part_of_proportions(const Results& results) {
  return fmt::format(
             "<h2 id='proportions'>Proportions correct</h2>\n<h3>All participants</h3>\n"
             "<table><thead><tr><th scope='col'>Of</th><th scope='col'>Condition</th><th "
             "scope='col' class='number'>Correct / judged"
             "</th><th scope='col' class='estimate'>Proportion [95 % interval]</th><th "
             "scope='col'>Interval by</th></tr>"
             "</thead>\n<tbody>{}</tbody></table>\n"
             "<p class='note'>Phonemes: all phones of the stimulus; answers that are not in the "
             "dictionary are left out, blank ones count as wrong. Consonants and vowels: as in the "
             "matrices below, so that answers not in the dictionary (&#8220;other&#8221;) and "
             "blank "
             "ones count as wrong and ambiguous alignments are left out.</p>\n",
             rows_of_pooled(results)) +
         table_of_individuals(results, Measure::Word, "Wilson") +
         table_of_individuals(
             results,
             Measure::Phoneme,
             "bootstrap over words, because the phones of one word are not independent");
}

std::string part_of_confusions(const Results& results, FigureNumbers& numbers) {
  std::string part =
      "<h2 id='confusions'>Confusions</h2>\n<p>Rows are the phones presented, columns those "
      "answered; both in order of place of articulation, front to back (vowels: front to back, "
      "then "
      "diphthongs), with thin lines between places. Cells are proportions of their row: colour on "
      "one scale for all matrices, numbers above .005; <i>n</i> is the number of presentations "
      "whose alignment is unambiguous (slanted and orange below 10). <i>deleted</i>: nothing of "
      "the answer stands in this place; "
      "<i>blank</i>: no answer; <i>other</i>: the answer is not in the dictionary.</p>\n";
  const Unit* last = nullptr;
  for (const auto& table : results.confusions) {
    if (last == nullptr || *last != table.unit) {
      part += fmt::format("<h3>{}</h3>\n", title(table.unit));
    }
    last = &table.unit;
    const auto total = table.matrix.total();
    part += fmt::format(
        "<figure data-unit='{}' data-condition='{}'>{}<figcaption><b>Figure {}. {}, condition "
        "{}.</b> {} Left out as ambiguous: {}. "
        "Words without such a phone: {}.</figcaption></figure>\n",
        name(table.unit),
        escaped(table.condition),
        figure_of_confusions(table, PaperWidth::TwoColumns),
        numbers.next(),
        title(table.unit),
        escaped(table.condition),
        total == 0 ? std::string{"No responses."}
                   : fmt::format("{}&#160;% correct ({} of {}, all columns counted).",
                                 print_percent(table.matrix.correct() / total),
                                 print_count(table.matrix.correct()),
                                 print_count(total)),
        table.ambiguous,
        table.lacking);
  }
  return part;
}

std::string part_of_likeness(const Results& results) {
  if (results.likeness.empty()) return {};
  std::string rows;
  for (const auto& row : results.likeness) {
    rows += fmt::format(
        "<tr><td>{}</td><td>{} &#183; {}</td><td class='number'>{}</td><td class='number'>{}"
        "</td><td class='number'>{} ({})</td><td class='number'>{} &#183; {}</td></tr>\n",
        title(row.unit),
        escaped(row.one),
        escaped(row.other),
        print_signed(row.likeness.correlation),
        print_signed(row.likeness.rms_deviation),
        row.likeness.cells,
        row.likeness.cells_used,
        row.trials_of_one,
        row.trials_of_other);
  }
  return fmt::format(
      "<h2 id='likeness'>How alike the errors of any two conditions "
      "are</h2>\n<table><thead><tr><th scope='col'>Unit</th>"
      "<th scope='col'>Conditions</th><th scope='col' class='number'>Correlation "
      "<i>r</i></th><th scope='col' class='number'>RMS "
      "difference</th><th scope='col' class='number'>Cells (not empty)</th><th scope='col' "
      "class='number'>Responses</th>"
      "</tr></thead>\n<tbody>{}</tbody></table>\n<p class='note'>Over off-diagonal cells (phones "
      "and <i>deleted</i>) of row proportions. Descriptive: cells empty in both conditions raise "
      "<i>r</i>, few presentations lower it, and no test is made; two conditions of the same "
      "participants are not independent.</p>\n",
      rows);
}

}  // namespace bimodal::analysis

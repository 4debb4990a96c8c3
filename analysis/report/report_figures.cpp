#include "analysis/report/report_figures.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "analysis/report/figures/heat_map.hpp"
#include "analysis/report/figures/proportion_figure.hpp"

namespace bimodal::analysis {

namespace {

std::vector<ParticipantDot> dots_of(const Results& results, std::string_view condition) {
  std::vector<ParticipantDot> dots;
  for (const auto& own : results.individual) {
    if (own.measure == Measure::Word && own.condition == condition && own.proportion) {
      dots.push_back({own.participant, *own.proportion});
    }
  }
  return dots;
}

/// Conditions are free text; file names are not.
std::string as_file_name(std::string text) {
  std::ranges::replace_if(
      text,
      [](char letter) {
        const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                           (letter >= '0' && letter <= '9') || letter == '-' || letter == '_';
        return !plain;
      },
      '_');
  return text;
}

}  // namespace

std::string figure_of_words(const Results& results, PaperWidth width) {
  std::vector<ProportionBar> bars;
  for (const auto& pooled : results.pooled) {
    if (pooled.measure != Measure::Word) continue;
    bars.push_back({.condition = pooled.condition,
                    .proportion = pooled.proportion,
                    .interval = pooled.interval,
                    .note = fmt::format("{} trials", pooled.judged),
                    .dots = dots_of(results, pooled.condition)});
  }
  return proportion_figure(bars, "proportion of words correct", width);
}

std::string figure_of_confusions(const UnitConfusions& confusions, PaperWidth width) {
  return heat_map(
      confusions.matrix,
      {.title = fmt::format("{}, condition {}", title(confusions.unit), confusions.condition),
       .width = width});
}

std::vector<ReportFigure> report_figures(const Results& results) {
  std::vector<ReportFigure> figures{
      {"words", [&results](PaperWidth width) { return figure_of_words(results, width); }}};
  for (const auto& confusions : results.confusions) {
    const auto name = fmt::format(
        "{}-{}", bimodal::analysis::name(confusions.unit), as_file_name(confusions.condition));
    figures.push_back({name, [&confusions](PaperWidth width) {
                         return figure_of_confusions(confusions, width);
                       }});
  }
  return figures;
}

}  // namespace bimodal::analysis

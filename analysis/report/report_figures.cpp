#include "analysis/report/report_figures.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "analysis/report/figures/benefit_figure.hpp"
#include "analysis/report/figures/dendrogram.hpp"
#include "analysis/report/figures/feature_figure.hpp"
#include "analysis/report/figures/heat_map.hpp"
#include "analysis/report/figures/layout_figure.hpp"
#include "analysis/report/figures/pair_figure.hpp"
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

std::string title_of(const UnitConfusions& confusions) {
  return fmt::format("{}, condition {}", title(confusions.unit), confusions.condition);
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
  return heat_map(confusions.matrix, {.title = title_of(confusions), .width = width});
}

bool has_structure(const UnitConfusions& confusions) {
  constexpr std::size_t kFewest = 3;
  return dissimilarities(confusions.matrix, DissimilarityMeasure::Phi).size() >= kFewest;
}

ClusterTable clusters_of(const UnitConfusions& confusions) {
  return tabulate_clusters(title_of(confusions),
                           confusions.matrix,
                           DissimilarityMeasure::Phi,
                           Linkage::Average,
                           kKeptByClasses);
}

LayoutTable layout_of(const UnitConfusions& confusions) {
  const auto unlike = dissimilarities(confusions.matrix, DissimilarityMeasure::Phi);
  return {.title = title_of(confusions),
          .measure = DissimilarityMeasure::Phi,
          .labels = unlike.labels(),
          .layout = scale_classically(unlike, 2)};
}

std::string figure_of_clusters(const UnitConfusions& confusions, PaperWidth width) {
  return dendrogram(clusters_of(confusions), width);
}

std::string figure_of_layout(const UnitConfusions& confusions, PaperWidth width) {
  std::vector<std::vector<std::string>> classes;
  for (const auto& made : clusters_of(confusions).classes) classes.push_back(made.members);
  return layout_figure(layout_of(confusions), classes, width);
}

std::string figure_of_comparison(const FaceComparison& comparison, PaperWidth width) {
  ConditionPair pair{.title = comparison.title,
                     .natural = comparison.one,
                     .synthetic = comparison.other,
                     .natural_matrix = comparison.one_matrix,
                     .synthetic_matrix = comparison.other_matrix,
                     .significant = {},
                     .test = "permutation test, false discovery rate .05"};
  if (comparison.permutation.p) {
    pair.significant.assign(comparison.permutation.cell_q.size(), false);
    const auto columns = comparison.one_matrix.responses().size();
    for (const auto& cell : significant_cells(comparison)) {
      pair.significant[cell.stimulus * columns + cell.response] = true;
    }
  }
  return pair_figure(pair, {}, width);
}

std::vector<std::string> voices_with_faces(const Results& results) {
  std::vector<std::string> voices;
  for (const auto& row : results.benefits) {
    if (std::ranges::find(voices, row.auditory) == voices.end()) voices.push_back(row.auditory);
  }
  return voices;
}

std::string figure_of_benefits(const Results& results,
                               const std::string& auditory,
                               PaperWidth width) {
  std::vector<BenefitSeries> series;
  for (const auto& row : results.benefits) {
    if (row.auditory != auditory) continue;
    auto& one = series.emplace_back();
    one.condition = row.bimodal;
    for (const auto& own : row.own) {
      one.points.push_back({own.participant, own.auditory, own.bimodal});
    }
  }
  return benefit_figure(series, auditory, width);
}

std::string figure_of_features(const Results& results, Unit unit, PaperWidth width) {
  std::vector<FeatureProfile> profiles;
  for (const auto& table : results.features) {
    if (table.unit != unit) continue;
    auto& profile = profiles.emplace_back();
    profile.condition = table.condition;
    for (const auto& feature : table.information.features) {
      auto& share = profile.shares.emplace_back();
      share.feature = feature.feature;
      if (!feature.information || !feature.information->relative) continue;
      share.observed = feature.information->relative;
      share.miller_madow =
          feature.information->miller_madow / feature.information->stimulus_entropy;
    }
  }
  return feature_figure(profiles, width);
}

std::vector<ReportFigure> report_figures(const Results& results) {
  std::vector<ReportFigure> figures{
      {"words", [&results](PaperWidth width) { return figure_of_words(results, width); }}};
  for (const auto& comparison : results.comparisons) {
    figures.push_back(
        {fmt::format("faces-{}", name(comparison.unit.value())),
         [&comparison](PaperWidth width) { return figure_of_comparison(comparison, width); }});
  }
  for (const auto& voice : voices_with_faces(results)) {
    figures.push_back({"benefit-" + as_file_name(voice), [&results, voice](PaperWidth width) {
                         return figure_of_benefits(results, voice, width);
                       }});
  }
  for (const Unit unit : kPlaceUnits) {
    if (std::ranges::find(results.features, unit, &FeatureProfileTable::unit) ==
        results.features.end()) {
      continue;
    }
    figures.push_back({fmt::format("features-{}", name(unit)), [&results, unit](PaperWidth width) {
                         return figure_of_features(results, unit, width);
                       }});
  }
  for (const auto& confusions : results.confusions) {
    const auto stem =
        fmt::format("{}-{}", name(confusions.unit), as_file_name(confusions.condition));
    const auto add = [&](const std::string& ending, auto draw) {
      figures.push_back({stem + ending, [&confusions, draw](PaperWidth width) {
                           return draw(confusions, width);
                         }});
    };
    add("", figure_of_confusions);
    if (!has_structure(confusions)) continue;
    add("-dendrogram", figure_of_clusters);
    add("-layout", figure_of_layout);
  }
  return figures;
}

}  // namespace bimodal::analysis

#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/report/figures/benefit_figure.hpp"
#include "analysis/report/figures/dendrogram.hpp"
#include "analysis/report/figures/feature_figure.hpp"
#include "analysis/report/figures/heat_map.hpp"
#include "analysis/report/figures/layout_figure.hpp"
#include "analysis/report/figures/pair_figure.hpp"
#include "analysis/report/figures/proportion_figure.hpp"

namespace bimodal::analysis::examples {

/// Six syllables answered by hand; n was not presented, "no & <idea>" is an answer that none is.
inline ConfusionMatrix syllables() {
  return {{"p", "b", "m", "t", "n"},
          {"p", "b", "m", "t", "n", "no & <idea>"},
          {40, 6, 2, 9,  2, 1, 7,  35, 6, 2, 8, 2, 1, 5, 44,
           0,  3, 7, 12, 2, 0, 38, 6,  2, 0, 0, 0, 0, 0, 0}};
}

/// The same, p and b more alike.
inline ConfusionMatrix other_syllables() {
  return {{"p", "b", "m", "t", "n"},
          {"p", "b", "m", "t", "n", "no & <idea>"},
          {20, 26, 2, 9,  2, 1, 27, 15, 6, 2, 8, 2, 1, 5,  44,
           0,  3,  7, 12, 2, 0, 38, 6,  2, 1, 2, 3, 4, 40, 0}};
}

/// As many stimuli as there are consonants, all correct.
inline ConfusionMatrix consonants() {
  const std::vector<std::string> labels{"P",  "B",  "M",  "W", "F", "V", "TH", "DH",
                                        "T",  "D",  "N",  "S", "Z", "L", "R",  "SH",
                                        "ZH", "CH", "JH", "Y", "K", "G", "NG", "HH"};
  ConfusionMatrix matrix{labels, labels};
  for (const auto& label : labels) matrix.add(label, label, 12.0);
  return matrix;
}

inline ConditionPair pair() {
  ConditionPair made{.title = "Syllables",
                     .natural = "natural",
                     .synthetic = "synthetic & <new>",
                     .natural_matrix = syllables(),
                     .synthetic_matrix = other_syllables(),
                     .significant = std::vector<bool>(30, false),
                     .test = "permutation test, false discovery rate .05"};
  made.significant[1] = true;  // p answered b
  made.significant[6] = true;  // b answered p
  return made;
}

inline std::vector<ProportionBar> bars() {
  return {{.condition = "auditory",
           .proportion = 0.55,
           .interval = Interval{0.5, 0.6},
           .note = "828 trials",
           .dots = {{"P<1>", 0.5}, {"P2", 0.6}}},
          {.condition = "visual & <only>",
           .proportion = std::nullopt,
           .interval = std::nullopt,
           .note = "0 trials",
           .dots = {}}};
}

inline std::vector<BenefitSeries> benefits() {
  return {{"natural", {{"P1", 0.5, 0.75}, {"P<2>", 0.25, 0.5}}}, {"synthetic", {{"P1", 0.5, 0.4}}}};
}

inline std::vector<FeatureProfile> features() {
  return {{"natural", {{"voicing", 0.05, -0.02}, {"place & <all>", 0.81, 0.78}}},
          {"synthetic", {{"voicing", 0.04, 0.01}, {"place & <all>", std::nullopt, std::nullopt}}}};
}

inline ClusterTable clusters(const ConfusionMatrix& matrix) {
  return tabulate_clusters("Syllables", matrix, DissimilarityMeasure::Phi, Linkage::Average, 0.75);
}

inline LayoutTable layout(const ConfusionMatrix& matrix) {
  const auto unlike = dissimilarities(matrix, DissimilarityMeasure::Phi);
  return {.title = "Syllables",
          .measure = DissimilarityMeasure::Phi,
          .labels = unlike.labels(),
          .layout = scale_classically(unlike, 2)};
}

/// One of every kind.
inline std::vector<std::string> all_figures(PaperWidth width) {
  return {heat_map(syllables(), {.title = "Syllables & <more>", .width = width}),
          heat_map(consonants(), {.title = "Consonants", .width = width}),
          pair_figure(pair(), {}, width),
          proportion_figure(bars(), "proportion of words correct", width),
          benefit_figure(benefits(), "auditory & <alone>", width),
          feature_figure(features(), width),
          dendrogram(clusters(other_syllables()), width),
          layout_figure(layout(other_syllables()), {{"p", "b"}, {"m", "t", "n"}}, width)};
}

/// What a program prints; absent if it cannot be run or fails.
inline std::optional<std::string> printed_by(const std::string& command) {
  FILE* const pipe = popen((command + " 2>/dev/null").c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::string text;
  for (int letter = std::fgetc(pipe); letter != EOF; letter = std::fgetc(pipe)) {
    text += static_cast<char>(letter);
  }
  if (pclose(pipe) != 0) return std::nullopt;
  return text;
}

}  // namespace bimodal::analysis::examples

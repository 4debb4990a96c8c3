#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "analysis/statistics/confusion_matrix.hpp"
#include "analysis/statistics/matrix_sampler.hpp"

namespace bimodal::analysis {

/// 18 consonants in seven visemes, as lipreaders confuse them: of the responses to each `within`
/// are in its viseme, half of these right; the others favour some responses.
class VisemeTruth {
 public:
  static constexpr std::size_t kLabels = 18;

  explicit VisemeTruth(double within) : proportions_(kLabels * kLabels) {
    for (std::size_t i = 0; i < kLabels; ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < kLabels; ++j) sum += at(i, j) = weight(i, j, within);
      for (std::size_t j = 0; j < kLabels; ++j) at(i, j) /= sum;
    }
  }

  /// Two stimuli that are answered alike from now on.
  void confuse(std::size_t one, std::size_t other) {
    for (std::size_t j = 0; j < kLabels; ++j) {
      at(one, j) = at(other, j) = (at(one, j) + at(other, j)) / 2.0;
    }
  }

  [[nodiscard]] const std::vector<double>& proportions() const { return proportions_; }

  /// Bits, all stimuli as often.
  [[nodiscard]] double transmitted() const {
    double bits = 0.0;
    for (std::size_t j = 0; j < kLabels; ++j) {
      double given = 0.0;
      for (std::size_t i = 0; i < kLabels; ++i) given += proportions_[i * kLabels + j] / kLabels;
      for (std::size_t i = 0; i < kLabels; ++i) {
        const double p = proportions_[i * kLabels + j];
        bits += p / kLabels * std::log2(p / given);
      }
    }
    return bits;
  }

  [[nodiscard]] MatrixSampler sampler(std::int64_t responses_a_row) const {
    return {proportions_, std::vector<std::int64_t>(kLabels, responses_a_row), kLabels};
  }

  /// Labels "0" to "17".
  static ConfusionMatrix matrix_of(const CellCounts& counts) {
    std::vector<std::string> labels;
    for (std::size_t i = 0; i < kLabels; ++i) labels.push_back(std::to_string(i));
    return {labels, labels, std::vector<double>(counts.begin(), counts.end())};
  }

 private:
  static constexpr std::array<std::size_t, kLabels> kVisemes{
      0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4, 5, 5, 5, 5, 6, 6};

  [[nodiscard]] double& at(std::size_t i, std::size_t j) { return proportions_[i * kLabels + j]; }

  static double weight(std::size_t i, std::size_t j, double within) {
    double members = 0.0;
    for (const auto viseme : kVisemes) members += viseme == kVisemes.at(i) ? 1.0 : 0.0;
    if (i == j) return within / 2.0;
    if (kVisemes.at(i) == kVisemes.at(j)) return within / 2.0 / (members - 1.0);
    const double favour = 1.0 + 0.4 * (static_cast<double>(7 * j % 5) - 2.0);
    return (1.0 - within) / (kLabels - members) * favour;
  }

  std::vector<double> proportions_;
};

}  // namespace bimodal::analysis

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bimodal::analysis {

/// How often each stimulus got each response. Rectangular: responses may have labels that no
/// stimulus has ("blank", "other"). Labels are text and never interpreted: "NA" is a syllable.
/// Counts are whole unless a response was shared out between cells ("averaged" alignments).
class ConfusionMatrix {
 public:
  ConfusionMatrix() = default;

  /// All counts 0. Labels within an axis are different.
  ConfusionMatrix(std::vector<std::string> stimuli, std::vector<std::string> responses);

  /// `counts` row by row, all >= 0.
  ConfusionMatrix(std::vector<std::string> stimuli,
                  std::vector<std::string> responses,
                  std::vector<double> counts);

  [[nodiscard]] const std::vector<std::string>& stimuli() const { return stimuli_; }

  [[nodiscard]] const std::vector<std::string>& responses() const { return responses_; }

  /// One more response, or a part of one; both labels exist.
  void add(std::string_view stimulus, std::string_view response, double weight = 1.0);

  [[nodiscard]] double count(std::size_t stimulus, std::size_t response) const;
  [[nodiscard]] double row_total(std::size_t stimulus) const;
  [[nodiscard]] double total() const;

  /// Responses whose label is that of their stimulus.
  [[nodiscard]] double correct() const;

  /// Share of the row; absent where the stimulus never occurred.
  [[nodiscard]] std::optional<double> proportion(std::size_t stimulus, std::size_t response) const;

 private:
  std::vector<std::string> stimuli_;
  std::vector<std::string> responses_;
  std::vector<double> counts_;  ///< row by row
};

/// How alike the errors of two matrices of the same labels are, over the off-diagonal cells of rows
/// that occur in both.
struct Likeness {
  std::size_t cells = 0;                ///< compared
  std::size_t cells_used = 0;           ///< not empty in both matrices
  std::optional<double> correlation;    ///< Pearson's, of row proportions; absent without spread
  std::optional<double> rms_deviation;  ///< root mean square difference of row proportions
};

/// Both matrices have the same labels. Responses named in `ignored` ("blank") are neither compared
/// nor counted in the rows' totals, nor are those compared that neither matrix has.
[[nodiscard]] Likeness compare_errors(const ConfusionMatrix& one,
                                      const ConfusionMatrix& other,
                                      const std::vector<std::string>& ignored = {});

}  // namespace bimodal::analysis

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/trial.hpp"
#include "analysis/scoring/score.hpp"
#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// The last columns of every confusion matrix, which no stimulus has.
inline constexpr std::string_view kDeleted =
    "deleted";                                       ///< nothing of the answer stands against it
inline constexpr std::string_view kBlank = "blank";  ///< there was no answer
inline constexpr std::string_view kOther = "other";  ///< the answer is not in the dictionary

/// Confusions of one unit in one condition.
struct UnitConfusions {
  Unit unit = Unit::ConsonantInitial;
  std::string condition;
  ConfusionMatrix matrix;
  std::int64_t ambiguous = 0;  ///< left out, because equally good alignments disagree
  std::int64_t lacking = 0;    ///< trials whose word has no such unit
};

/// Every unit in every condition, conditions within units. Matrices of a unit share their labels:
/// the stimuli that occur in any condition; these and all responses, in the order of the Phone
/// enumeration; then deleted, blank, other. `scores` belong to `trials` one by one.
[[nodiscard]] std::vector<UnitConfusions> tabulate_confusions(
    std::span<const Trial> trials,
    std::span<const Score> scores,
    std::span<const std::string> conditions);

/// How alike two conditions' errors in a unit are; blank and other responses are not compared.
struct ConditionLikeness {
  Unit unit = Unit::ConsonantInitial;
  std::string one;
  std::string other;
  double trials_of_one = 0;
  double trials_of_other = 0;
  Likeness likeness;
};

[[nodiscard]] std::vector<ConditionLikeness> compare_conditions(
    std::span<const UnitConfusions> confusions);

}  // namespace bimodal::analysis

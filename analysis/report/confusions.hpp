#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/trial.hpp"
#include "analysis/scoring/label_pair.hpp"
#include "analysis/scoring/score.hpp"
#include "analysis/statistics/confusion_matrix.hpp"

namespace bimodal::analysis {

/// Confusions of one unit in one condition.
struct UnitConfusions {
  Unit unit = Unit::ConsonantInitial;
  std::string condition;
  ConfusionMatrix matrix;
  std::int64_t ambiguous = 0;       ///< stimuli left out, because equally good alignments disagree
  std::int64_t lacking = 0;         ///< trials whose word has no such unit
  std::int64_t without_phones = 0;  ///< of these, trials of which nobody knows how the word is said
};

/// One unit in every condition. The matrices share their labels: the stimuli that occur in any
/// condition; these and all responses; then deleted, blank, other (blank and other of clusters,
/// blank of words). Labels are in the order of the Phone enumeration, clusters phone by phone,
/// words by the alphabet. `scores` belong to `trials` one by one.
[[nodiscard]] std::vector<UnitConfusions> tabulate_unit(std::span<const Trial> trials,
                                                        std::span<const Score> scores,
                                                        std::span<const std::string> conditions,
                                                        Unit unit);

/// Every unit of kPlaceUnits in every condition, conditions within units.
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

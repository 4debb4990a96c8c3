#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/trial.hpp"
#include "analysis/scoring/score.hpp"
#include "analysis/statistics/crossed_bootstrap.hpp"
#include "analysis/statistics/interval.hpp"

namespace bimodal::analysis {

/// What can be right or wrong in an answer. Words, and units of words, are judged once a trial;
/// phonemes are all phones of the stimulus.
enum class Measure { Word, Phoneme, ConsonantInitial, Vowel, ConsonantFinal };

inline constexpr std::array kMeasures{Measure::Word,
                                      Measure::Phoneme,
                                      Measure::ConsonantInitial,
                                      Measure::Vowel,
                                      Measure::ConsonantFinal};

/// "word", "phoneme", "consonant-initial", "vowel", "consonant-final".
[[nodiscard]] std::string_view name(Measure measure);

/// A proportion correct and how sure it is.
struct Proportion {
  Measure measure = Measure::Word;
  std::string condition;
  std::string participant;  ///< empty: all participants pooled
  std::int64_t participants = 0;
  std::int64_t words = 0;  ///< different ones
  std::int64_t correct = 0;
  std::int64_t judged = 0;           ///< what `correct` is a part of
  std::optional<double> proportion;  ///< absent if nothing was judged
  std::optional<Interval> interval;  ///< 95 %
  std::string method;                ///< of the interval, or why there is none
};

/// Every measure in one condition, pooled (crossed bootstrap; Wilson where there is one
/// participant) and then for each participant (Wilson; phonemes, which come several to a word, by
/// resampling words). `scores` belong to `trials` one by one; `participants` gives the order.
[[nodiscard]] std::vector<Proportion> measure_condition(std::span<const Trial> trials,
                                                        std::span<const Score> scores,
                                                        const std::string& condition,
                                                        std::span<const std::string> participants,
                                                        CrossedBootstrap::Options options);

}  // namespace bimodal::analysis

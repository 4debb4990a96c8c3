#pragma once

#include <span>
#include <string>

#include "analysis/data/trial.hpp"
#include "analysis/scoring/score.hpp"

namespace bimodal::analysis {

/// How the answer lies along the stimulus, place by place: "S>deleted T>T UW>UW". Of an ambiguous
/// place every partner with its share of the best alignments: "S>deleted(.50)/B(.50)". Empty where
/// the stimulus has no phones.
[[nodiscard]] std::string print_alignment(const Score& score);

/// One line for each trial: who, what, verdict, phones and alignment. `scores` belong to `trials`
/// one by one. Text is separated by tabs.
[[nodiscard]] std::string scored_trials_text(std::span<const Trial> trials,
                                             std::span<const Score> scores);
[[nodiscard]] std::string scored_trials_csv(std::span<const Trial> trials,
                                            std::span<const Score> scores);
[[nodiscard]] std::string scored_trials_json(std::span<const Trial> trials,
                                             std::span<const Score> scores);

}  // namespace bimodal::analysis

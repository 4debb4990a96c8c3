#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/data/trial.hpp"
#include "analysis/scoring/score.hpp"

namespace bimodal::analysis {

/// What became of the answers of one condition, or of one participant in it.
struct ScoreRow {
  std::string condition;
  std::string participant;  ///< empty: all together
  std::int64_t trials = 0;
  std::int64_t exact = 0;      ///< spelled as the word
  std::int64_t homophone = 0;  ///< correct by sound
  std::int64_t tolerated = 0;  ///< correct by a rule of tolerance
  std::int64_t wrong = 0;      ///< another word of the dictionary
  std::int64_t omissions = 0;
  std::int64_t out_of_dictionary = 0;
  std::int64_t no_pronunciation = 0;  ///< trials of any kind whose stimulus has no phones
  std::int64_t phonemes = 0;          ///< of stimuli, judged
  std::int64_t phonemes_correct = 0;
  std::int64_t insertions = 0;  ///< phones of answers that stand against none
  std::int64_t aligned = 0;     ///< answers that had to be aligned: not correct, and with phones
  std::int64_t ambiguous = 0;   ///< of these, equally good alignments disagree on some phone

  /// Absent without trials, phonemes judged, answers aligned.
  [[nodiscard]] std::optional<double> word_proportion() const;
  [[nodiscard]] std::optional<double> phoneme_proportion() const;
  [[nodiscard]] std::optional<double> ambiguous_proportion() const;
};

struct ScoreTable {
  ScoringRules rules;
  std::vector<ScoreRow> conditions;
  std::vector<ScoreRow> participants;  ///< within conditions; none if not asked for
};

/// `scores` belong to `trials` one by one. A row for every one of `conditions`, and for every one
/// of `participants` that has trials in it.
[[nodiscard]] ScoreTable tabulate_scores(std::span<const Trial> trials,
                                         std::span<const Score> scores,
                                         std::span<const std::string> conditions,
                                         std::span<const std::string> participants,
                                         const ScoringRules& rules);

/// For people: counts and proportions, and a note on the rules.
[[nodiscard]] std::string score_text(const ScoreTable& table);

/// Every figure in full precision; rows of conditions have no participant.
[[nodiscard]] std::string score_csv(const ScoreTable& table);

/// The same as JSON: "conditions", "participants" if asked for, and the "rules".
[[nodiscard]] std::string score_json(const ScoreTable& table);

}  // namespace bimodal::analysis

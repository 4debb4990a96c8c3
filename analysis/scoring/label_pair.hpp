#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/trial.hpp"
#include "analysis/scoring/score.hpp"
#include "analysis/scoring/unit.hpp"

namespace bimodal::analysis {

/// The last columns of every confusion matrix, which no stimulus has.
inline constexpr std::string_view kDeleted =
    "deleted";                                       ///< nothing of the answer stands against it
inline constexpr std::string_view kBlank = "blank";  ///< there was no answer
inline constexpr std::string_view kOther = "other";  ///< the answer is not in the dictionary

/// The label of an onset or coda without consonants.
inline constexpr std::string_view kNoConsonant = "none";

/// A stimulus and what it was taken for.
struct LabelPair {
  std::string stimulus;
  std::string response;
  double weight = 1.0;  ///< less than 1 where a response is shared out

  bool operator==(const LabelPair&) const = default;
};

/// What a trial presents in a unit: the symbol of a phone ("S"), of every phone for phonemes; the
/// symbols of a cluster ("S T", "none"); the folded spelling of the word. A word that is spelled as
/// one of the labels above stands in apostrophes: "'blank'". Empty: the word has no such unit, or
/// nobody knows how it is said.
[[nodiscard]] std::vector<std::string> stimuli_of(const Trial& trial, Unit unit);

/// What a trial adds to the confusion matrix of a unit; the weights of one stimulus sum to 1. Empty
/// where it has no such unit or its answer is ambiguous and left out; for phonemes this goes phone
/// by phone.
///
/// The response to a phone is its partner in the alignment. The response to an onset is the
/// answer's own onset, in whichever alignment, and so for codas; equally good pronunciations that
/// differ in it are ambiguous. The response to a word is the answer as it is spelled, but of an
/// answer that counts as correct the word.
[[nodiscard]] std::vector<LabelPair> confusions_of(const Trial& trial,
                                                   const Score& score,
                                                   Unit unit);

}  // namespace bimodal::analysis

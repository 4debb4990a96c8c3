#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/trial.hpp"
#include "analysis/scoring/unit.hpp"
#include "stimuli/words/dictionary.hpp"

namespace bimodal::analysis {

/// What an answer is, as a word.
enum class Verdict {
  Correct,    ///< the word itself
  Homophone,  ///< another spelling that can be said as was presented; counts as correct
  Wrong,      ///< another word of the dictionary
  Unknown,    ///< not in the dictionary, so without phones; a wrong word
  Omission,   ///< blank; a wrong word
};

/// "correct", "homophone", "wrong", "not in dictionary", "omission".
[[nodiscard]] std::string_view name(Verdict verdict);

/// What was answered in the place of one stimulus phone.
struct UnitScore {
  enum class Outcome {
    Answered,   ///< with `answer`, which may be the stimulus itself
    Deleted,    ///< nothing of the answer stands against it
    Blank,      ///< there was no answer
    Other,      ///< the answer is not in the dictionary
    Ambiguous,  ///< equally good alignments disagree: left out of the confusions
  };

  Phone stimulus = Phone::Rest;
  Outcome outcome = Outcome::Blank;
  Phone answer = Phone::Rest;  ///< where answered
};

/// A trial's answer, judged.
struct Score {
  Verdict verdict = Verdict::Omission;
  std::string answer;  ///< folded (fold_spelling)
  int phones = 0;      ///< in the stimulus
  /// Stimulus phones found in the answer: 0 for an omission, absent if the answer is unknown.
  std::optional<int> phones_correct;
  std::array<std::optional<UnitScore>, kUnits.size()> units;  ///< absent: the word has none

  [[nodiscard]] bool word_correct() const {
    return verdict == Verdict::Correct || verdict == Verdict::Homophone;
  }
};

/// A word is correct if its spelling is (an apostrophe may be left out, unless that makes another
/// word), or if any pronunciation that the dictionary gives for the answer is the one that was
/// presented: "red" for "read" said as R EH D, but not said as R IY D. All phones of a correct word
/// are correct. Else the answer's pronunciations are aligned with the phones presented.
[[nodiscard]] Score score(const Trial& trial, const Dictionary& dictionary);

/// One score for each trial, in their order.
[[nodiscard]] std::vector<Score> score_all(std::span<const Trial> trials,
                                           const Dictionary& dictionary);

}  // namespace bimodal::analysis

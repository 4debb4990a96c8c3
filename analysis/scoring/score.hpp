#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/trial.hpp"
#include "analysis/scoring/alignment.hpp"
#include "analysis/scoring/scoring_rules.hpp"
#include "analysis/scoring/unit.hpp"
#include "stimuli/words/dictionary.hpp"
#include "stimuli/words/letter_to_sound.hpp"

namespace bimodal::analysis {

/// What an answer is, as a word.
enum class Verdict : std::uint8_t {
  Correct,    ///< the word itself
  Homophone,  ///< another spelling that can be said as was presented; counts as correct
  Tolerated,  ///< neither, but a rule of tolerance accepts it; counts as correct
  Wrong,      ///< another word of the dictionary
  Unknown,    ///< not in the dictionary; a wrong word, without phones unless rules give them
  Omission,   ///< blank; a wrong word
};

inline constexpr std::size_t kVerdictCount = 6;

/// "correct", "homophone", "tolerated", "wrong", "not in dictionary", "omission".
[[nodiscard]] std::string_view name(Verdict verdict);

/// What was answered in the place of one stimulus phone.
struct UnitScore {
  enum class Outcome : std::uint8_t {
    Answered,   ///< with `answer`, which may be the stimulus itself
    Deleted,    ///< nothing of the answer stands against it
    Blank,      ///< there was no answer
    Other,      ///< the answer is not in the dictionary
    Ambiguous,  ///< equally good alignments disagree: Score::shares has what they say
  };

  Phone stimulus = Phone::Rest;
  Outcome outcome = Outcome::Blank;
  Phone answer = Phone::Rest;  ///< where answered
};

/// One of the partners of an ambiguous stimulus phone.
struct PartnerShare {
  std::uint32_t place = 0;  ///< among the phones of the stimulus, from 0
  Partner partner;
  double share = 0.0;  ///< of the best alignments; a place's shares sum to 1
};

/// A way to say the answer that is as good as any other.
struct SaidAnswer {
  Pronunciation phones;
  double share = 0.0;  ///< of the best alignments; an answer's shares sum to 1
};

/// A trial's answer, judged.
struct Score {
  Verdict verdict = Verdict::Omission;
  std::optional<Tolerance> tolerance;  ///< by which rule it is tolerated; else absent
  std::string answer;                  ///< folded (fold_spelling)
  int phones = 0;                      ///< in the stimulus; 0 if nobody knows how it is said
  /// Stimulus phones found in the answer: 0 for an omission; absent if the stimulus or the answer
  /// has no phones.
  std::optional<int> phones_correct;
  int insertions = 0;                ///< phones of an answer that stand against none
  TieRule ties = TieRule::LeftOut;   ///< what becomes of ambiguous phones in confusions
  std::vector<UnitScore> places;     ///< one for every phone of the stimulus
  std::vector<PartnerShare> shares;  ///< of the ambiguous places
  std::vector<SaidAnswer> said;      ///< where aligned: neither correct nor blank, and with phones
  /// The places of kPlaceUnits; absent: the word has none.
  std::array<std::optional<UnitScore>, kPlaceUnits.size()> units;

  [[nodiscard]] bool word_correct() const {
    return verdict == Verdict::Correct || verdict == Verdict::Homophone ||
           verdict == Verdict::Tolerated;
  }

  /// Whether equally good alignments disagree on any phone.
  [[nodiscard]] bool ambiguous() const { return !shares.empty(); }
};

/// Judges answers by fixed rules.
///
/// A word is correct if its spelling is (an apostrophe may be left out, unless that makes another
/// word), or, where homophones count, if any pronunciation that the dictionary gives for the answer
/// is the one that was presented: "red" for "read" said as R EH D, but not said as R IY D; or if a
/// rule of tolerance takes it. All phones of a correct word are correct, also of a tolerated one:
/// that it was heard is what the rule says. Else the answer's pronunciations are aligned with the
/// phones presented.
///
/// The answer's pronunciations are those of the dictionary; if it has none, of its words one after
/// the other, in their first pronunciations, where numbers or compounds are tolerated; if these
/// have none, and answers outside of the dictionary are not left out, of the letter-to-sound rules,
/// written as the dictionary writes (W for WH, AH for AX). An answer said by these is "not in the
/// dictionary" and wrong, unless it sounds as was presented: then it is a homophone.
///
/// Where the stimulus has no phones, the word is judged by spelling and tolerance alone.
class Scorer {
 public:
  /// `dictionary` outlives the scorer. Throws Error if letter-to-sound rules are wanted and cannot
  /// be read.
  explicit Scorer(const Dictionary& dictionary, const ScoringRules& rules = {});

  [[nodiscard]] Score score(const Trial& trial) const;

 private:
  struct Sound;  ///< how an answer is said

  [[nodiscard]] Sound sound_of(const Trial& trial, const std::string& folded) const;
  [[nodiscard]] std::optional<Pronunciation> said_in_parts(const Trial& trial,
                                                           const std::string& folded) const;
  [[nodiscard]] Pronunciation said_by_rules(const std::string& folded) const;
  void judge(const Trial& trial, const Sound& sound, Score& scored) const;

  const Dictionary& dictionary_;
  ScoringRules rules_;
  std::optional<LetterToSound> letter_to_sound_;
};

/// The score of one trial.
[[nodiscard]] Score score(const Trial& trial,
                          const Dictionary& dictionary,
                          const ScoringRules& rules = {});

/// One score for each trial, in their order.
[[nodiscard]] std::vector<Score> score_all(std::span<const Trial> trials,
                                           const Dictionary& dictionary,
                                           const ScoringRules& rules = {});

}  // namespace bimodal::analysis

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace bimodal::analysis {

/// What may be forgiven in a word that is not spelled as the stimulus. The first five make the word
/// correct; Compounds says how an answer sounds that the dictionary has in parts only.
enum class Tolerance {
  DoubleLetters,  ///< "stuf" for "stuff"; not if the answer is another word ("god" for "good")
  Plural,         ///< "cats" for "cat", "foxes" for "fox", "city" for "cities"
  Tense,          ///< "walked" or "walking" for "walk", "went" for "go", each for each
  Contractions,   ///< "cannot" for "can't", "we'll" for "we will"
  Numbers,        ///< "2" for "two"; so "8" sounds as "eight"
  /// "ice cream" sounds as "ice" and then "cream" where the dictionary lacks "icecream": else it is
  /// not in the dictionary. In spelling, spaces and hyphens never count, by this rule or without.
  Compounds,
};

inline constexpr std::array kTolerances{Tolerance::DoubleLetters,
                                        Tolerance::Plural,
                                        Tolerance::Tense,
                                        Tolerance::Contractions,
                                        Tolerance::Numbers,
                                        Tolerance::Compounds};

/// "double-letters", "plural", "tense", "contractions", "numbers", "compounds".
[[nodiscard]] std::string_view name(Tolerance tolerance);

[[nodiscard]] std::optional<Tolerance> tolerance_from_name(std::string_view name);

/// What becomes of the phones of an answer that the dictionary lacks.
enum class OutOfDictionary {
  LeftOut,        ///< it is left out of phoneme scores, and counted
  LetterToSound,  ///< they are those of the letter-to-sound rules (Elovitz et al., 1976)
};

/// What it costs to align two phones that differ.
enum class AlignmentCosts {
  Unit,     ///< 1
  Feature,  ///< the share of their phonetic features in which they differ (phone_features.hpp)
};

/// What becomes of a stimulus phone to which equally good alignments give different answers.
enum class TieRule {
  LeftOut,   ///< it is left out of the confusions, and counted
  Averaged,  ///< each of the best alignments weighs the same; so a response may count in parts
};

/// "leave-out", "letter-to-sound"; "unit", "feature"; "leave-out", "average": as options name them.
[[nodiscard]] std::string_view name(OutOfDictionary rule);
[[nodiscard]] std::string_view name(AlignmentCosts costs);
[[nodiscard]] std::string_view name(TieRule rule);

/// By which rules answers are scored.
struct ScoringRules {
  bool homophones = true;  ///< another spelling that can be said as was presented is correct
  std::array<bool, kTolerances.size()> tolerated{};  ///< by Tolerance; none
  OutOfDictionary out_of_dictionary = OutOfDictionary::LeftOut;
  AlignmentCosts costs = AlignmentCosts::Unit;
  TieRule ties = TieRule::LeftOut;

  [[nodiscard]] bool tolerates(Tolerance tolerance) const {
    return tolerated.at(static_cast<std::size_t>(tolerance));
  }

  void tolerate(Tolerance tolerance) { tolerated.at(static_cast<std::size_t>(tolerance)) = true; }

  bool operator==(const ScoringRules&) const = default;
};

/// For a note under a table: "Homophones count as correct. Tolerated: plural, tense. ..."
[[nodiscard]] std::string describe_rules(const ScoringRules& rules);

}  // namespace bimodal::analysis

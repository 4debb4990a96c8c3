#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "stimuli/timeline/phone.hpp"

namespace bimodal::analysis {

/// What is taken together as one stimulus when confusions are tabulated.
enum class Unit {
  ConsonantInitial,  ///< the first phone of a word that begins with a consonant
  Vowel,             ///< the first vowel
  ConsonantFinal,    ///< the last phone of a word that ends with a consonant
  Onset,             ///< all consonants before the first vowel, maybe none
  Coda,              ///< all consonants after the last vowel, maybe none
  Phoneme,           ///< every phone, wherever it stands
  Word,              ///< the spelling, so also of syllables and other stimuli without phones
};

inline constexpr std::array kUnits{Unit::ConsonantInitial,
                                   Unit::Vowel,
                                   Unit::ConsonantFinal,
                                   Unit::Onset,
                                   Unit::Coda,
                                   Unit::Phoneme,
                                   Unit::Word};

/// Those that are one phone at one place of a word; the report shows them.
inline constexpr std::array kPlaceUnits{Unit::ConsonantInitial, Unit::Vowel, Unit::ConsonantFinal};

/// "consonant-initial", "vowel", "consonant-final", "onset", "coda", "phoneme", "word": as options
/// and tables name them.
[[nodiscard]] std::string_view name(Unit unit);

/// "Initial consonants", "Vowels", "Final consonants", "Onsets", "Codas", "Phonemes", "Words".
[[nodiscard]] std::string_view title(Unit unit);

[[nodiscard]] std::optional<Unit> unit_from_name(std::string_view name);

/// Where a unit of kPlaceUnits is among a word's phones: the first phone if it is a consonant (so
/// the first of an onset cluster), the first vowel, the last phone if it is a consonant. Absent if
/// there is none, and for the other units.
[[nodiscard]] std::optional<std::size_t> place_of(Unit unit, std::span<const Phone> phones);

/// The consonants before the first vowel; all phones if there is no vowel.
[[nodiscard]] std::span<const Phone> onset_of(std::span<const Phone> phones);

/// The consonants after the last vowel; none if there is no vowel.
[[nodiscard]] std::span<const Phone> coda_of(std::span<const Phone> phones);

}  // namespace bimodal::analysis

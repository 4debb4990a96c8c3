#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "stimuli/timeline/phone.hpp"

namespace bimodal::analysis {

/// The places of a one-syllable word whose confusions are tabulated.
enum class Unit { ConsonantInitial, Vowel, ConsonantFinal };

inline constexpr std::array kUnits{Unit::ConsonantInitial, Unit::Vowel, Unit::ConsonantFinal};

/// "consonant-initial", "vowel", "consonant-final": as options and tables name them.
[[nodiscard]] std::string_view name(Unit unit);

/// "Initial consonants", "Vowels", "Final consonants".
[[nodiscard]] std::string_view title(Unit unit);

[[nodiscard]] std::optional<Unit> unit_from_name(std::string_view name);

/// Where the unit is among a word's phones: the first phone if it is a consonant (so the first of
/// an onset cluster), the first vowel, the last phone if it is a consonant. Absent if there is
/// none.
[[nodiscard]] std::optional<std::size_t> place_of(Unit unit, std::span<const Phone> phones);

}  // namespace bimodal::analysis

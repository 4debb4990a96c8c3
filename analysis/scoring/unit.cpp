#include "analysis/scoring/unit.hpp"

#include <algorithm>

namespace bimodal::analysis {

namespace {

struct Naming {
  std::string_view name;
  std::string_view title;
};

constexpr std::array<Naming, kUnits.size()> kNamings{{
    {"consonant-initial", "Initial consonants"},
    {"vowel", "Vowels"},
    {"consonant-final", "Final consonants"},
    {"onset", "Onsets"},
    {"coda", "Codas"},
    {"phoneme", "Phonemes"},
    {"word", "Words"},
}};

}  // namespace

std::string_view name(Unit unit) {
  return kNamings.at(static_cast<std::size_t>(unit)).name;
}

std::string_view title(Unit unit) {
  return kNamings.at(static_cast<std::size_t>(unit)).title;
}

std::optional<Unit> unit_from_name(std::string_view name) {
  for (const Unit unit : kUnits) {
    if (analysis::name(unit) == name) return unit;
  }
  return std::nullopt;
}

std::optional<std::size_t> place_of(Unit unit, std::span<const Phone> phones) {
  const auto vowel = std::ranges::find_if(phones, is_vowel);
  switch (unit) {
    case Unit::ConsonantInitial:
      if (phones.empty() || vowel == phones.begin()) return std::nullopt;
      return 0;
    case Unit::Vowel:
      if (vowel == phones.end()) return std::nullopt;
      return static_cast<std::size_t>(vowel - phones.begin());
    case Unit::ConsonantFinal:
      if (vowel == phones.end() || !is_consonant(phones.back())) return std::nullopt;
      return phones.size() - 1;
    case Unit::Onset:
    case Unit::Coda:
    case Unit::Phoneme:
    case Unit::Word:
      break;
  }
  return std::nullopt;
}

std::span<const Phone> onset_of(std::span<const Phone> phones) {
  const auto vowel = std::ranges::find_if(phones, is_vowel);
  return phones.first(static_cast<std::size_t>(vowel - phones.begin()));
}

std::span<const Phone> coda_of(std::span<const Phone> phones) {
  std::size_t consonants = 0;
  while (consonants < phones.size() && !is_vowel(phones[phones.size() - 1 - consonants])) {
    ++consonants;
  }
  if (consonants == phones.size()) return {};
  return phones.last(consonants);
}

}  // namespace bimodal::analysis

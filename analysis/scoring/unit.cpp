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
  }
  return std::nullopt;
}

}  // namespace bimodal::analysis

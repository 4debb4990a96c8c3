#include "stimuli/timeline/festival_phones.hpp"

#include <algorithm>
#include <array>

namespace bimodal {

namespace {

struct Entry {
  Phone phone;
  std::string_view symbol;
};

constexpr std::array<Entry, kPhoneCount> kSymbols{{
    {Phone::Rest, "pau"}, {Phone::P, "p"},   {Phone::B, "b"},   {Phone::M, "m"},
    {Phone::W, "w"},      {Phone::WH, "w"},  {Phone::F, "f"},   {Phone::V, "v"},
    {Phone::TH, "th"},    {Phone::DH, "dh"}, {Phone::T, "t"},   {Phone::D, "d"},
    {Phone::N, "n"},      {Phone::S, "s"},   {Phone::Z, "z"},   {Phone::L, "l"},
    {Phone::R, "r"},      {Phone::SH, "sh"}, {Phone::ZH, "zh"}, {Phone::CH, "ch"},
    {Phone::JH, "jh"},    {Phone::Y, "y"},   {Phone::K, "k"},   {Phone::G, "g"},
    {Phone::NG, "ng"},    {Phone::HH, "hh"}, {Phone::IY, "iy"}, {Phone::IH, "ih"},
    {Phone::EY, "ey"},    {Phone::EH, "eh"}, {Phone::AE, "ae"}, {Phone::AA, "aa"},
    {Phone::AH, "ah"},    {Phone::AX, "ax"}, {Phone::ER, "er"}, {Phone::AO, "ao"},
    {Phone::OW, "ow"},    {Phone::UH, "uh"}, {Phone::UW, "uw"}, {Phone::AY, "ay"},
    {Phone::AW, "aw"},    {Phone::OY, "oy"},
}};

constexpr bool in_order_of_the_enumeration() {
  for (std::size_t i = 0; i < kPhoneCount; ++i) {
    if (static_cast<std::size_t>(kSymbols.at(i).phone) != i) return false;
  }
  return true;
}

static_assert(in_order_of_the_enumeration());

/// Symbols of the phone set that are nobody's own.
constexpr std::array<Entry, 9> kVariants{{
    {Phone::Rest, "h#"},
    {Phone::Rest, "brth"},
    {Phone::ER, "axr"},
    {Phone::D, "dx"},
    {Phone::HH, "hv"},
    {Phone::N, "nx"},
    {Phone::L, "el"},
    {Phone::M, "em"},
    {Phone::N, "en"},
}};

bool is_syllabic_consonant(std::string_view symbol) {
  return symbol == "el" || symbol == "em" || symbol == "en";
}

}  // namespace

std::string_view festival_symbol(Phone phone) {
  return kSymbols.at(static_cast<std::size_t>(phone)).symbol;
}

std::vector<Phone> phones_from_festival(std::string_view symbol) {
  const auto* const own = std::ranges::find(kSymbols, symbol, &Entry::symbol);
  if (own != kSymbols.end()) return {own->phone};
  const auto* const variant = std::ranges::find(kVariants, symbol, &Entry::symbol);
  if (variant == kVariants.end()) return {};
  if (is_syllabic_consonant(symbol)) return {Phone::AX, variant->phone};
  return {variant->phone};
}

bool realises(std::string_view symbol, Phone asked) {
  if (symbol == festival_symbol(asked)) return true;
  if (symbol == "ax") return is_vowel(asked);
  if (symbol == "axr") return asked == Phone::ER;
  if (symbol == "dx") return asked == Phone::T || asked == Phone::D;
  if (symbol == "hv") return asked == Phone::HH;
  if (symbol == "nx") return asked == Phone::N;
  return false;
}

}  // namespace bimodal

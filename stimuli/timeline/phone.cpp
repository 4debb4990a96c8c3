#include "stimuli/timeline/phone.hpp"

#include <algorithm>
#include <cctype>
#include <string>

namespace bimodal {

namespace {

struct Entry {
  Phone phone;
  std::string_view symbol;
};

constexpr std::array<Entry, kPhoneCount> kPhones{{
    {Phone::Rest, "rest"}, {Phone::P, "P"},   {Phone::B, "B"},   {Phone::M, "M"},
    {Phone::W, "W"},       {Phone::WH, "WH"}, {Phone::F, "F"},   {Phone::V, "V"},
    {Phone::TH, "TH"},     {Phone::DH, "DH"}, {Phone::T, "T"},   {Phone::D, "D"},
    {Phone::N, "N"},       {Phone::S, "S"},   {Phone::Z, "Z"},   {Phone::L, "L"},
    {Phone::R, "R"},       {Phone::SH, "SH"}, {Phone::ZH, "ZH"}, {Phone::CH, "CH"},
    {Phone::JH, "JH"},     {Phone::Y, "Y"},   {Phone::K, "K"},   {Phone::G, "G"},
    {Phone::NG, "NG"},     {Phone::HH, "HH"}, {Phone::IY, "IY"}, {Phone::IH, "IH"},
    {Phone::EY, "EY"},     {Phone::EH, "EH"}, {Phone::AE, "AE"}, {Phone::AA, "AA"},
    {Phone::AH, "AH"},     {Phone::AX, "AX"}, {Phone::ER, "ER"}, {Phone::AO, "AO"},
    {Phone::OW, "OW"},     {Phone::UH, "UH"}, {Phone::UW, "UW"}, {Phone::AY, "AY"},
    {Phone::AW, "AW"},     {Phone::OY, "OY"},
}};

constexpr std::array<Phone, kPhoneCount> kOrder = [] {
  std::array<Phone, kPhoneCount> order{};
  for (std::size_t i = 0; i < kPhoneCount; ++i) order.at(i) = kPhones.at(i).phone;
  return order;
}();

constexpr bool in_order_of_the_enumeration() {
  for (std::size_t i = 0; i < kPhoneCount; ++i) {
    if (static_cast<std::size_t>(kPhones.at(i).phone) != i) return false;
  }
  return true;
}

static_assert(in_order_of_the_enumeration());

constexpr std::array kAy{Phone::AA, Phone::IH};
constexpr std::array kAw{Phone::AA, Phone::UH};
constexpr std::array kOy{Phone::AO, Phone::IH};

}  // namespace

std::span<const Phone> all_phones() {
  return kOrder;
}

std::string_view symbol(Phone phone) {
  return kPhones.at(static_cast<std::size_t>(phone)).symbol;
}

std::optional<Phone> phone_from_symbol(std::string_view symbol) {
  std::string upper{symbol};
  std::ranges::transform(upper, upper.begin(), [](unsigned char letter) {
    return static_cast<char>(std::toupper(letter));
  });
  if (upper.size() > 1 && upper.back() >= '0' && upper.back() <= '2') upper.pop_back();
  if (upper == "REST" || upper == "SIL" || upper == "PAU") return Phone::Rest;
  const auto* const found = std::ranges::find(kPhones, std::string_view{upper}, &Entry::symbol);
  if (found == kPhones.end()) return std::nullopt;
  return found->phone;
}

bool is_vowel(Phone phone) {
  return phone >= Phone::IY;
}

bool is_consonant(Phone phone) {
  return phone >= Phone::P && phone <= Phone::HH;
}

std::span<const Phone> face_segments(Phone phone) {
  switch (phone) {
    case Phone::AY:
      return kAy;
    case Phone::AW:
      return kAw;
    case Phone::OY:
      return kOy;
    default:
      return std::span{kOrder}.subspan(static_cast<std::size_t>(phone), 1);
  }
}

std::string spell(std::span<const Phone> phones) {
  std::string text;
  for (const Phone phone : phones) {
    if (!text.empty()) text += ' ';
    text += symbol(phone);
  }
  return text;
}

}  // namespace bimodal

#include "stimuli/timeline/phone_notation.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/nearest.hpp"
#include "stimuli/base/utf8.hpp"

namespace bimodal {

namespace {

constexpr std::string_view kBlank = " \t\r\n";
constexpr std::array kExample{Phone::S, Phone::T, Phone::UW};

struct Entry {
  Phone phone;
  std::string_view ipa;
  std::string_view x_sampa;
};

constexpr std::array<Entry, kPhoneCount> kPhones{{
    {Phone::Rest, "|", "|"}, {Phone::P, "p", "p"},    {Phone::B, "b", "b"},
    {Phone::M, "m", "m"},    {Phone::W, "w", "w"},    {Phone::WH, "ʍ", "W"},
    {Phone::F, "f", "f"},    {Phone::V, "v", "v"},    {Phone::TH, "θ", "T"},
    {Phone::DH, "ð", "D"},   {Phone::T, "t", "t"},    {Phone::D, "d", "d"},
    {Phone::N, "n", "n"},    {Phone::S, "s", "s"},    {Phone::Z, "z", "z"},
    {Phone::L, "l", "l"},    {Phone::R, "ɹ", "r\\"},  {Phone::SH, "ʃ", "S"},
    {Phone::ZH, "ʒ", "Z"},   {Phone::CH, "t͡ʃ", "tS"}, {Phone::JH, "d͡ʒ", "dZ"},
    {Phone::Y, "j", "j"},    {Phone::K, "k", "k"},    {Phone::G, "ɡ", "g"},
    {Phone::NG, "ŋ", "N"},   {Phone::HH, "h", "h"},   {Phone::IY, "i", "i"},
    {Phone::IH, "ɪ", "I"},   {Phone::EY, "eɪ", "eI"}, {Phone::EH, "ɛ", "E"},
    {Phone::AE, "æ", "{"},   {Phone::AA, "ɑ", "A"},   {Phone::AH, "ʌ", "V"},
    {Phone::AX, "ə", "@"},   {Phone::ER, "ɝ", "3`"},  {Phone::AO, "ɔ", "O"},
    {Phone::OW, "oʊ", "oU"}, {Phone::UH, "ʊ", "U"},   {Phone::UW, "u", "u"},
    {Phone::AY, "aɪ", "aI"}, {Phone::AW, "aʊ", "aU"}, {Phone::OY, "ɔɪ", "OI"},
}};

constexpr bool in_order_of_the_enumeration() {
  for (std::size_t i = 0; i < kPhoneCount; ++i) {
    if (static_cast<std::size_t>(kPhones.at(i).phone) != i) return false;
  }
  return true;
}

static_assert(in_order_of_the_enumeration());

struct Reading {
  std::string_view symbol;
  Phone phone;
};

/// What else is understood: other symbols of the same sounds, and broader or narrower ones that
/// can mean nothing else in American English. Without tie bars.
constexpr std::array<Reading, 22> kAlsoIpa{{
    {"tʃ", Phone::CH}, {"ʧ", Phone::CH},   {"dʒ", Phone::JH}, {"ʤ", Phone::JH},  {"r", Phone::R},
    {"ɻ", Phone::R},   {"g", Phone::G},    {"ɫ", Phone::L},   {"ɾ", Phone::D},   {"ɦ", Phone::HH},
    {"ɚ", Phone::ER},  {"ɜ", Phone::ER},   {"ɜɹ", Phone::ER}, {"ɜr", Phone::ER}, {"ɒ", Phone::AA},
    {"əʊ", Phone::OW}, {"ai", Phone::AY},  {"au", Phone::AW}, {"ei", Phone::EY}, {"ou", Phone::OW},
    {"ɔi", Phone::OY}, {"‖", Phone::Rest},
}};

constexpr std::array<Reading, 20> kAlsoXSampa{{
    {"t_S", Phone::CH}, {"d_Z", Phone::JH}, {"r", Phone::R},     {"r\\`", Phone::R},
    {"5", Phone::L},    {"l_G", Phone::L},  {"4", Phone::D},     {"h\\", Phone::HH},
    {"@`", Phone::ER},  {"3", Phone::ER},   {"3r\\", Phone::ER}, {"3r", Phone::ER},
    {"Q", Phone::AA},   {"@U", Phone::OW},  {"ai", Phone::AY},   {"au", Phone::AW},
    {"ei", Phone::EY},  {"ou", Phone::OW},  {"Oi", Phone::OY},   {"||", Phone::Rest},
}};

/// Join two letters of one sound: passed over even within a symbol.
constexpr std::array<std::string_view, 3> kTies{"\u0361", "\u035C", "\u032F"};
/// Stress, length, syllables, and what a transcription may be put into: end a symbol.
constexpr std::array<std::string_view, 13> kIpaMarks{
    "ˈ", "ˌ", "ː", "ˑ", "'", ":", ".", "-", "/", "[", "]", " ", "\u203F"};
constexpr std::array<std::string_view, 11> kXSampaMarks{
    "\"", "%", ":\\", ":", ".", "-\\", "-", "/", "[", "]", " "};

std::span<const std::string_view> marks_of(Notation notation) {
  if (notation == Notation::Ipa) return kIpaMarks;
  return kXSampaMarks;
}

std::span<const Reading> also_read(Notation notation) {
  if (notation == Notation::Ipa) return kAlsoIpa;
  return kAlsoXSampa;
}

std::string_view name_of(Notation notation) {
  switch (notation) {
    case Notation::Ipa:
      return "IPA";
    case Notation::XSampa:
      return "X-SAMPA";
    default:
      return "ARPAbet";
  }
}

/// A transcription without tie bars.
struct Untied {
  std::string text;
  std::vector<std::size_t> places;  ///< of each byte's character in the original, from 1
};

/// Precondition: UTF-8.
Untied without_ties(std::string_view text) {
  Untied untied;
  std::size_t place = 1;
  for (std::size_t at = 0; at < text.size(); ++place) {
    const auto character = text.substr(at, utf8_length(text, at));
    at += character.size();
    if (std::ranges::find(kTies, character) != kTies.end()) continue;
    const bool is_blank = kBlank.find(character) != std::string_view::npos;
    untied.text += is_blank ? " " : character;
    untied.places.resize(untied.text.size(), place);
  }
  return untied;
}

/// How many bytes of a mark the text begins with; 0 if with none.
std::size_t mark_length(std::string_view text, Notation notation) {
  for (const auto mark : marks_of(notation)) {
    if (text.starts_with(mark)) return mark.size();
  }
  return 0;
}

/// The longest symbol that the text begins with.
std::optional<Reading> first_symbol(std::string_view text, Notation notation) {
  std::optional<Reading> longest;
  const auto consider = [&](const Reading& reading) {
    if (!text.starts_with(reading.symbol)) return;
    if (!longest || reading.symbol.size() > longest->symbol.size()) longest = reading;
  };
  for (const Phone phone : all_phones()) consider({written(phone, notation), phone});
  for (const auto& reading : also_read(notation)) consider(reading);
  return longest;
}

/// "near it is eɪ (EY)": the symbols that begin so, and how this notation writes what the other one
/// means by it; all symbols if there is nothing near.
std::string near(std::string_view unknown, Notation notation) {
  const auto other = notation == Notation::Ipa ? Notation::XSampa : Notation::Ipa;
  std::vector<std::string> names;
  std::vector<std::string_view> known;
  for (const Phone phone : all_phones()) {
    const auto own = written(phone, notation);
    known.push_back(own);
    if (own.starts_with(unknown) || written(phone, other) == unknown) {
      names.push_back(fmt::format("{} ({})", own, symbol(phone)));
    }
  }
  if (names.empty()) return fmt::format("the symbols are {}", fmt::join(known, " "));
  return fmt::format("near it {} {}", names.size() == 1 ? "is" : "are", fmt::join(names, ", "));
}

Error refusal(std::string_view text, Notation notation, const std::string& finding) {
  return Error{fmt::format("reading \"{}\" as {}: {}", text, name_of(notation), finding)};
}

std::vector<Phone> read_symbols(std::string_view text, Notation notation) {
  if (!is_utf8(text)) throw refusal(text, notation, "it is not UTF-8; save it as UTF-8");
  const auto untied = without_ties(text);
  std::vector<Phone> phones;
  std::string_view rest{untied.text};
  while (!rest.empty()) {
    if (const auto length = mark_length(rest, notation); length > 0) {
      rest.remove_prefix(length);
    } else if (const auto reading = first_symbol(rest, notation)) {
      phones.push_back(reading->phone);
      rest.remove_prefix(reading->symbol.size());
    } else {
      const auto unknown = rest.substr(0, utf8_length(rest, 0));
      throw refusal(text,
                    notation,
                    fmt::format("\"{}\", character {}, is no symbol; {}",
                                unknown,
                                untied.places[untied.text.size() - rest.size()],
                                near(unknown, notation)));
    }
  }
  return phones;
}

std::vector<Phone> read_arpabet(std::string_view text) {
  std::vector<Phone> phones;
  std::string_view rest{text};
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kBlank), rest.size()));
    if (rest.empty()) return phones;
    const auto symbol_text = rest.substr(0, rest.find_first_of(kBlank));
    rest.remove_prefix(symbol_text.size());
    const auto phone = phone_from_symbol(symbol_text);
    if (!phone) {
      std::vector<std::string_view> known;
      for (const Phone one : all_phones()) known.push_back(symbol(one));
      const auto meant = nearest(symbol_text, known);
      throw refusal(text,
                    Notation::Arpabet,
                    fmt::format("\"{}\", symbol {}, is no phone; {}",
                                symbol_text,
                                phones.size() + 1,
                                meant ? fmt::format("did you mean {}?", *meant)
                                      : fmt::format("the symbols are {}", fmt::join(known, " "))));
    }
    phones.push_back(*phone);
  }
}

}  // namespace

std::string_view written(Phone phone, Notation notation) {
  const auto& entry = kPhones.at(static_cast<std::size_t>(phone));
  switch (notation) {
    case Notation::Ipa:
      return entry.ipa;
    case Notation::XSampa:
      return entry.x_sampa;
    default:
      return symbol(phone);
  }
}

std::string write_phones(std::span<const Phone> phones, Notation notation) {
  if (notation == Notation::Arpabet) return spell(phones);
  std::string text;
  for (std::size_t i = 0; i < phones.size(); ++i) {
    const auto one = written(phones[i], notation);
    if (i > 0) {
      const auto pair = std::string{written(phones[i - 1], notation)}.append(one);
      if (!std::ranges::equal(read_symbols(pair, notation), phones.subspan(i - 1, 2))) text += '.';
    }
    text += one;
  }
  return text;
}

std::vector<Phone> read_phones(std::string_view text, Notation notation) {
  auto phones = notation == Notation::Arpabet ? read_arpabet(text) : read_symbols(text, notation);
  if (!phones.empty()) return phones;
  throw refusal(
      text,
      notation,
      fmt::format("there are no phones; write e.g. \"{}\"", write_phones(kExample, notation)));
}

}  // namespace bimodal

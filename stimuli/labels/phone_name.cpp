#include "stimuli/labels/phone_name.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "stimuli/labels/labels.hpp"
#include "stimuli/timeline/festival_phones.hpp"

namespace bimodal {

namespace {

using Kind = PhoneName::Kind;

struct Entry {
  std::string_view name;
  Kind kind;
  Phone phone;
};

/// What TIMIT has beyond Festival's phone set.
constexpr std::array<Entry, 12> kTimit{{
    {"bcl", Kind::Closure, Phone::B},
    {"dcl", Kind::Closure, Phone::D},
    {"gcl", Kind::Closure, Phone::G},
    {"pcl", Kind::Closure, Phone::P},
    {"tcl", Kind::Closure, Phone::T},
    {"kcl", Kind::Closure, Phone::K},
    {"q", Kind::Glottal, Phone::Rest},
    {"epi", Kind::Phones, Phone::Rest},
    {"ux", Kind::Phones, Phone::UW},
    {"ix", Kind::Phones, Phone::IH},
    {"ax-h", Kind::Phones, Phone::AX},
    {"eng", Kind::Phones, Phone::NG},
}};

/// Stops and affricates of one place, by the place of the stop.
Phone place(Phone phone) {
  switch (phone) {
    case Phone::P:
    case Phone::B:
      return Phone::P;
    case Phone::T:
    case Phone::D:
    case Phone::CH:
    case Phone::JH:
      return Phone::T;
    case Phone::K:
    case Phone::G:
      return Phone::K;
    default:
      return Phone::Rest;
  }
}

/// In small letters, without the stress digit.
std::string plain_name(std::string_view text) {
  std::string name{text};
  std::ranges::transform(name, name.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  if (name.size() > 1 && name.back() >= '0' && name.back() <= '2') name.pop_back();
  return name;
}

}  // namespace

PhoneName phone_name(std::string_view text) {
  if (is_silence(text)) return {Kind::Phones, {Phone::Rest}};
  if (const auto phone = phone_from_symbol(text)) return {Kind::Phones, {*phone}};
  const auto name = plain_name(text);
  const auto* const timit = std::ranges::find(kTimit, std::string_view{name}, &Entry::name);
  if (timit != kTimit.end()) return {timit->kind, {timit->phone}};
  auto phones = phones_from_festival(name);
  if (phones.empty()) return {};
  return {Kind::Phones, std::move(phones)};
}

bool is_release(Phone stop, Phone phone) {
  return place(phone) != Phone::Rest && place(phone) == place(stop);
}

}  // namespace bimodal

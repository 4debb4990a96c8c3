#include "analysis/report/place_class.hpp"

#include <algorithm>
#include <array>

#include "stimuli/timeline/phone.hpp"

namespace bimodal::analysis {

namespace {

/// Phones up to and including `last`, and behind the entry before, in the order of the enumeration.
struct PlaceClass {
  Phone last;
  std::string_view name;
};

constexpr std::array kClasses = std::to_array<PlaceClass>({
    {Phone::Rest, "no phone"},
    {Phone::M, "bilabial"},
    {Phone::WH, "labio-velar"},
    {Phone::V, "labiodental"},
    {Phone::DH, "dental"},
    {Phone::R, "alveolar"},
    {Phone::JH, "palato-alveolar"},
    {Phone::Y, "palatal"},
    {Phone::NG, "velar"},
    {Phone::HH, "glottal"},
    {Phone::AE, "front"},
    {Phone::ER, "central"},
    {Phone::UW, "back"},
    {Phone::OY, "diphthong"},
});

}  // namespace

std::string_view place_class(std::string_view symbol) {
  const auto phone = phone_from_symbol(symbol).value_or(Phone::Rest);
  return std::ranges::lower_bound(kClasses, phone, {}, &PlaceClass::last)->name;
}

}  // namespace bimodal::analysis

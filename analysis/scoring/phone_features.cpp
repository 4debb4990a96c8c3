#include "analysis/scoring/phone_features.hpp"

#include <array>
#include <cassert>
#include <cstddef>

namespace bimodal::analysis {

namespace {

constexpr std::size_t kConsonants = 25;
constexpr std::size_t kVowels = 16;

struct Consonant {
  Phone phone = Phone::Rest;
  ConsonantFeatures features;
};

struct Vowel {
  Phone phone = Phone::Rest;
  VowelFeatures features;
};

constexpr bool kVoiced = true;
constexpr bool kVoiceless = false;
constexpr bool kRounded = true;
constexpr bool kSpread = false;
constexpr bool kTense = true;
constexpr bool kLax = false;

constexpr std::array<Consonant, kConsonants> kConsonantTable{{
    {Phone::P, {kVoiceless, Place::Bilabial, Manner::Stop}},
    {Phone::B, {kVoiced, Place::Bilabial, Manner::Stop}},
    {Phone::M, {kVoiced, Place::Bilabial, Manner::Nasal}},
    {Phone::W, {kVoiced, Place::LabioVelar, Manner::Approximant}},
    {Phone::WH, {kVoiceless, Place::LabioVelar, Manner::Approximant}},
    {Phone::F, {kVoiceless, Place::Labiodental, Manner::Fricative}},
    {Phone::V, {kVoiced, Place::Labiodental, Manner::Fricative}},
    {Phone::TH, {kVoiceless, Place::Dental, Manner::Fricative}},
    {Phone::DH, {kVoiced, Place::Dental, Manner::Fricative}},
    {Phone::T, {kVoiceless, Place::Alveolar, Manner::Stop}},
    {Phone::D, {kVoiced, Place::Alveolar, Manner::Stop}},
    {Phone::N, {kVoiced, Place::Alveolar, Manner::Nasal}},
    {Phone::S, {kVoiceless, Place::Alveolar, Manner::Fricative}},
    {Phone::Z, {kVoiced, Place::Alveolar, Manner::Fricative}},
    {Phone::L, {kVoiced, Place::Alveolar, Manner::Lateral}},
    {Phone::R, {kVoiced, Place::Alveolar, Manner::Approximant}},
    {Phone::SH, {kVoiceless, Place::PalatoAlveolar, Manner::Fricative}},
    {Phone::ZH, {kVoiced, Place::PalatoAlveolar, Manner::Fricative}},
    {Phone::CH, {kVoiceless, Place::PalatoAlveolar, Manner::Affricate}},
    {Phone::JH, {kVoiced, Place::PalatoAlveolar, Manner::Affricate}},
    {Phone::Y, {kVoiced, Place::Palatal, Manner::Approximant}},
    {Phone::K, {kVoiceless, Place::Velar, Manner::Stop}},
    {Phone::G, {kVoiced, Place::Velar, Manner::Stop}},
    {Phone::NG, {kVoiced, Place::Velar, Manner::Nasal}},
    {Phone::HH, {kVoiceless, Place::Glottal, Manner::Fricative}},
}};

constexpr std::array<Vowel, kVowels> kVowelTable{{
    {Phone::IY, {Height::High, Backness::Front, kSpread, kTense, Glide::None}},
    {Phone::IH, {Height::High, Backness::Front, kSpread, kLax, Glide::None}},
    {Phone::EY, {Height::Mid, Backness::Front, kSpread, kTense, Glide::Front}},
    {Phone::EH, {Height::Mid, Backness::Front, kSpread, kLax, Glide::None}},
    {Phone::AE, {Height::Low, Backness::Front, kSpread, kLax, Glide::None}},
    {Phone::AA, {Height::Low, Backness::Back, kSpread, kTense, Glide::None}},
    {Phone::AH, {Height::Mid, Backness::Back, kSpread, kLax, Glide::None}},
    {Phone::AX, {Height::Mid, Backness::Central, kSpread, kLax, Glide::None}},
    {Phone::ER, {Height::Mid, Backness::Central, kSpread, kTense, Glide::None}},
    {Phone::AO, {Height::Low, Backness::Back, kRounded, kTense, Glide::None}},
    {Phone::OW, {Height::Mid, Backness::Back, kRounded, kTense, Glide::Back}},
    {Phone::UH, {Height::High, Backness::Back, kRounded, kLax, Glide::None}},
    {Phone::UW, {Height::High, Backness::Back, kRounded, kTense, Glide::None}},
    {Phone::AY, {Height::Low, Backness::Back, kSpread, kTense, Glide::Front}},
    {Phone::AW, {Height::Low, Backness::Back, kSpread, kTense, Glide::Back}},
    {Phone::OY, {Height::Low, Backness::Back, kRounded, kTense, Glide::Front}},
}};

constexpr int difference(const ConsonantFeatures& one, const ConsonantFeatures& other) {
  constexpr int kWeight = kAllFeatures / 3;
  return (one.voiced != other.voiced ? kWeight : 0) + (one.place != other.place ? kWeight : 0) +
         (one.manner != other.manner ? kWeight : 0);
}

constexpr int difference(const VowelFeatures& one, const VowelFeatures& other) {
  constexpr int kWeight = kAllFeatures / 5;
  return (one.height != other.height ? kWeight : 0) +
         (one.backness != other.backness ? kWeight : 0) +
         (one.rounded != other.rounded ? kWeight : 0) + (one.tense != other.tense ? kWeight : 0) +
         (one.glide != other.glide ? kWeight : 0);
}

/// Every phone from `first` on has its line, in the order of the enumeration, and no two of them
/// have the same features.
template <typename Table>
constexpr bool complete_and_distinct(const Table& table, Phone first) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (static_cast<std::size_t>(table.at(i).phone) != static_cast<std::size_t>(first) + i) {
      return false;
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (difference(table.at(i).features, table.at(j).features) == 0) return false;
    }
  }
  return true;
}

static_assert(1 + kConsonants + kVowels == kPhoneCount);
static_assert(complete_and_distinct(kConsonantTable, Phone::P));
static_assert(complete_and_distinct(kVowelTable, Phone::IY));

constexpr std::array<std::string_view, 9> kPlaces{"bilabial",
                                                  "labio-velar",
                                                  "labiodental",
                                                  "dental",
                                                  "alveolar",
                                                  "palato-alveolar",
                                                  "palatal",
                                                  "velar",
                                                  "glottal"};
constexpr std::array<std::string_view, 6> kManners{
    "stop", "affricate", "fricative", "nasal", "lateral", "approximant"};

std::size_t places_after(Phone phone, Phone first) {
  return static_cast<std::size_t>(phone) - static_cast<std::size_t>(first);
}

}  // namespace

const ConsonantFeatures& consonant_features(Phone consonant) {
  assert(is_consonant(consonant));
  return kConsonantTable.at(places_after(consonant, Phone::P)).features;
}

const VowelFeatures& vowel_features(Phone vowel) {
  assert(is_vowel(vowel));
  return kVowelTable.at(places_after(vowel, Phone::IY)).features;
}

std::string_view name(Place place) {
  return kPlaces.at(static_cast<std::size_t>(place));
}

std::string_view name(Manner manner) {
  return kManners.at(static_cast<std::size_t>(manner));
}

int feature_difference(Phone one, Phone other) {
  assert(is_vowel(one) == is_vowel(other));
  return is_vowel(one) ? difference(vowel_features(one), vowel_features(other))
                       : difference(consonant_features(one), consonant_features(other));
}

}  // namespace bimodal::analysis

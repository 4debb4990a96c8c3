#pragma once

#include <string_view>

#include "stimuli/timeline/phone.hpp"

namespace bimodal::analysis {

/// Phonetic features of American English as textbooks have them (Ladefoged, A Course in Phonetics),
/// so coarse that each phone has its own set. W and WH are labio-velar, R is alveolar, as in the
/// order of Phone.
enum class Place {
  Bilabial,
  LabioVelar,
  Labiodental,
  Dental,
  Alveolar,
  PalatoAlveolar,
  Palatal,
  Velar,
  Glottal,
};

enum class Manner { Stop, Affricate, Fricative, Nasal, Lateral, Approximant };

struct ConsonantFeatures {
  bool voiced = false;
  Place place = Place::Bilabial;
  Manner manner = Manner::Stop;
};

enum class Height { High, Mid, Low };
enum class Backness { Front, Central, Back };

/// Where a diphthong goes: EY AY OY to the front, OW AW to the back.
enum class Glide { None, Front, Back };

/// Height, backness and rounding of a diphthong are those of its beginning.
struct VowelFeatures {
  Height height = Height::High;
  Backness backness = Backness::Front;
  bool rounded = false;
  bool tense = false;  ///< and so longer
  Glide glide = Glide::None;
};

/// Of a consonant.
[[nodiscard]] const ConsonantFeatures& consonant_features(Phone consonant);

/// Of a vowel.
[[nodiscard]] const VowelFeatures& vowel_features(Phone vowel);

/// "bilabial", "labio-velar"; "stop", "affricate".
[[nodiscard]] std::string_view name(Place place);
[[nodiscard]] std::string_view name(Manner manner);

/// In how much of their features two consonants, or two vowels, differ, in fifteenths: each of the
/// 3 features of consonants and of the 5 of vowels weighs the same, 5 and 3. At least 3 for phones
/// that are not the same; from P to B 5, from P to ZH 15.
inline constexpr int kAllFeatures = 15;
[[nodiscard]] int feature_difference(Phone one, Phone other);

}  // namespace bimodal::analysis

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bimodal {

/// The speech sounds of English as this project writes them: the ARPAbet of Elovitz et al. (1976),
/// 16 vowels and 25 consonants, and rest (silence). Consonants stand in order of place of
/// articulation, front to back; vowels from front to back and then the diphthongs.
enum class Phone : std::uint8_t {
  Rest,
  // consonants: bilabial, labio-velar, labiodental, dental, alveolar, palato-alveolar, palatal,
  // velar, glottal
  P,
  B,
  M,
  W,
  WH,
  F,
  V,
  TH,
  DH,
  T,
  D,
  N,
  S,
  Z,
  L,
  R,
  SH,
  ZH,
  CH,
  JH,
  Y,
  K,
  G,
  NG,
  HH,
  // vowels
  IY,
  IH,
  EY,
  EH,
  AE,
  AA,
  AH,
  AX,
  ER,
  AO,
  OW,
  UH,
  UW,
  AY,
  AW,
  OY,
};

inline constexpr std::size_t kPhoneCount = 42;

/// Every phone, in the order of the enumeration, which is also the order of every table and figure.
[[nodiscard]] std::span<const Phone> all_phones();

/// "P", "AY", "rest".
[[nodiscard]] std::string_view symbol(Phone phone);

/// The phone of an ARPAbet symbol in any case, with or without a stress digit ("ah0" is AH); absent
/// if there is none. "rest", "sil" and "pau" are Rest.
[[nodiscard]] std::optional<Phone> phone_from_symbol(std::string_view symbol);

[[nodiscard]] bool is_vowel(Phone phone);
[[nodiscard]] bool is_consonant(Phone phone);

/// What the face articulates for a phone: itself, or the two halves of AY (AA IH), AW (AA UH) and
/// OY (AO IH). So the face knows 39 segments: 13 vowels, 25 consonants and rest.
[[nodiscard]] std::span<const Phone> face_segments(Phone phone);

/// Pronunciations are sequences of phones without rest.
using Pronunciation = std::vector<Phone>;

/// "S T UW".
[[nodiscard]] std::string spell(std::span<const Phone> phones);

}  // namespace bimodal

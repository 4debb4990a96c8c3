#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "stimuli/timeline/utterance.hpp"

namespace bimodal::synth {

/// What is fitted as one: a phone, or a half of a diphthong. Halves have targets of their own (the
/// start of AY is wider open than that of AW) and the dynamics of their class.
struct Part {
  std::string_view name;        ///< "B", "AY start", "rest"
  std::string_view class_name;  ///< parts of one class share alpha and t_o
  Phone segment;                ///< the segment of the face whose target and dynamics it tells
};

/// Every part. Classes are those of the fit to natural lips that the shipped dynamics come from
/// ("lips" in synth/assets/segments/english.json): 19 classes of the phones of six GRID sentences.
/// Phones that those lack are in the class of their nearest neighbour, as in that file.
[[nodiscard]] std::span<const Part> parts();

/// The names of all classes, in the order of their first parts.
[[nodiscard]] std::span<const std::string_view> part_classes();

/// Index into part_classes().
[[nodiscard]] std::size_t class_of(std::size_t part);

/// Index into parts(); absent if there is none of this name.
[[nodiscard]] std::optional<std::size_t> part_named(std::string_view name);

/// One part of an utterance. Times in ms from the start of the recording.
struct SpokenPart {
  std::size_t part = 0;  ///< index into parts()
  /// The part's middle; of the rest before and after speech, kRestDistance outside of the speech.
  double centre_ms = 0;
  bool begins = false;  ///< the rest before speech: its dominance is constant before its peak
  bool ends = false;    ///< the rest after speech: constant behind its peak

  bool operator==(const SpokenPart&) const = default;
};

/// The parts of an utterance in order, as the face articulates them (segments_of, claims_on), but
/// EY is two halves here: diphthongs are halved 55 to 45 and neighbouring rests are one. Where the
/// utterance begins or ends with speech there is a rest before or after it all the same. Empty if
/// the utterance is all rest.
[[nodiscard]] std::vector<SpokenPart> spoken_parts(const Utterance& utterance);

}  // namespace bimodal::synth

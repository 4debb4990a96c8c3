#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "stimuli/timeline/segment.hpp"

namespace bimodal::synth {

/// How long a phone lasts by itself.
struct IntrinsicDuration {
  Milliseconds shortest{};  ///< MINDUR: however much is taken from it
  Milliseconds inherent{};  ///< INHDUR: in a stressed syllable at the end of a phrase
};

/// Allen, J., Hunnicutt, M. S. & Klatt, D. (1987), From text to speech: the MITalk system, table
/// 9-1, in ms (by way of others' notes on it). Rest lasts 200 ms, the pause of its rule 1.
[[nodiscard]] IntrinsicDuration intrinsic_duration(Phone phone);

/// Of an ambiguous segment in proportion between its two phones.
[[nodiscard]] IntrinsicDuration intrinsic_duration(const Segment& segment);

enum class Stress : std::uint8_t { Primary, Secondary, None };

/// The inherent duration; an unstressed vowel by their rule 7: 70 % of what is beyond half of the
/// shortest duration. Secondary stress is half way between (chosen by us).
[[nodiscard]] Milliseconds duration_of(const Segment& segment, Stress stress = Stress::Primary);

/// Segments one after the other, each with its intrinsic duration; with rest before and after,
/// where there is none.
[[nodiscard]] std::vector<TimedSegment> timed(std::span<const Segment> segments);

/// The same at another speaking rate: 2 halves all durations. Precondition: rate > 0.
[[nodiscard]] std::vector<TimedSegment> at_rate(std::vector<TimedSegment> segments, double rate);

/// Segments as somebody typed them, "S:140 T:60 UW1", parted by blanks: a symbol (see
/// parse_segment), with a stress digit on vowels (0 none, 1 primary, 2 secondary) and a duration in
/// ms where they are wanted. A segment without duration has duration_of. As timed(), with rest
/// around. Throws Error, naming the word that is wrong, what is, and how to write it.
[[nodiscard]] std::vector<TimedSegment> typed_segments(std::string_view text);

}  // namespace bimodal::synth

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "stimuli/base/quantity.hpp"
#include "stimuli/timeline/phone.hpp"

namespace bimodal {

/// What the face articulates for a stretch of time: a phone, or an ambiguous sound some steps of
/// the way from one phone to another (Cohen & Massaro 1993, section 4: "seven intermediate
/// articulations between /b/ and /w/"), written "B~W:3/8" for step 3 of 8.
struct Segment {
  Phone from = Phone::Rest;
  Phone to = Phone::Rest;  ///< as `from` in a plain phone
  int step = 0;            ///< 0 is `from`, `steps` is `to`
  int steps = 1;           ///< 1 to kMostSteps

  constexpr Segment() = default;

  /// A plain phone. Implicit: wherever a segment may stand, a phone may.
  constexpr Segment(Phone phone) : from{phone}, to{phone} {}

  constexpr Segment(Phone first, Phone last, int at, int of)
      : from{first}, to{last}, step{at}, steps{of} {}

  [[nodiscard]] constexpr bool is_ambiguous() const { return from != to; }

  /// How far from `from` to `to`, 0 to 1.
  [[nodiscard]] constexpr double share() const { return static_cast<double>(step) / steps; }

  /// The phone that it is nearer to: what a voice says that has no ambiguous sounds. Halfway it is
  /// `from`.
  [[nodiscard]] constexpr Phone nearer() const { return 2 * step <= steps ? from : to; }

  bool operator==(const Segment&) const = default;
};

inline constexpr int kMostSteps = 1'000;

/// "S", "rest", "B~W:3/8".
[[nodiscard]] std::string symbol(const Segment& segment);

/// "S T UW", "B~W:3/8 AA".
[[nodiscard]] std::string spell(std::span<const Segment> segments);

/// Why a text is no segment.
struct SegmentFault {
  std::string finding;  ///< `"q" is no phone`
  std::string remedy;   ///< `write ARPAbet symbols, e.g. "S T UW"`
};

/// The segment of a symbol in any case: a phone (as phone_from_symbol), or two of them with "~"
/// between and a step, "b~w:3/8".
[[nodiscard]] std::variant<Segment, SegmentFault> parse_segment(std::string_view symbol);

/// The same for a sound of a word: rest, and what lies on the way to it, is refused.
[[nodiscard]] std::variant<Segment, SegmentFault> parse_sound(std::string_view symbol);

/// A word as it is written, some of whose sounds may be ambiguous: what a voice says of it, and
/// what a face does.
struct SpelledSegments {
  Pronunciation phones;  ///< the nearer phone of each
  /// As many segments as phones; empty if none is ambiguous: the face does what is heard.
  std::vector<Segment> articulation;

  bool operator==(const SpelledSegments&) const = default;
};

[[nodiscard]] SpelledSegments spelled(std::span<const Segment> segments);

/// What the face articulates for a segment (see face_segments of a phone): itself, or the halves of
/// a diphthong. On the way between a diphthong and another phone, that phone stands for both
/// halves; at the ends it is the diphthong, and the other phone alone.
[[nodiscard]] std::vector<Segment> face_segments(const Segment& segment);

/// One segment and when it lasts, from the start of the utterance.
struct TimedSegment {
  Segment segment;
  Milliseconds start{};
  Milliseconds duration{};

  [[nodiscard]] Milliseconds centre() const { return start + duration / 2; }

  [[nodiscard]] Milliseconds end() const { return start + duration; }

  bool operator==(const TimedSegment&) const = default;
};

}  // namespace bimodal

#include "synth/speech/durations.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::synth {

namespace {

struct Row {
  Phone phone;
  double shortest_ms;
  double inherent_ms;
};

using enum Phone;

constexpr std::array<Row, kPhoneCount> kDurations{{
    {Rest, 200, 200}, {P, 50, 90},    {B, 60, 85},   {M, 60, 70},    {W, 60, 80},    {WH, 60, 70},
    {F, 80, 100},     {V, 40, 60},    {TH, 60, 90},  {DH, 30, 50},   {T, 50, 75},    {D, 50, 75},
    {N, 50, 60},      {S, 60, 105},   {Z, 40, 75},   {L, 40, 80},    {R, 30, 80},    {SH, 80, 105},
    {ZH, 40, 70},     {CH, 50, 70},   {JH, 50, 70},  {Y, 40, 80},    {K, 60, 80},    {G, 60, 80},
    {NG, 60, 95},     {HH, 20, 80},   {IY, 55, 155}, {IH, 40, 135},  {EY, 100, 190}, {EH, 70, 150},
    {AE, 80, 230},    {AA, 100, 240}, {AH, 60, 140}, {AX, 60, 120},  {ER, 80, 180},  {AO, 100, 240},
    {OW, 80, 220},    {UH, 60, 160},  {UW, 70, 210}, {AY, 150, 250}, {AW, 100, 260}, {OY, 150, 280},
}};

constexpr bool in_order_of_the_phones() {
  for (std::size_t i = 0; i < kPhoneCount; ++i) {
    if (static_cast<std::size_t>(kDurations.at(i).phone) != i) return false;
  }
  return true;
}

static_assert(in_order_of_the_phones());

constexpr double kLongestMs = 60'000;

std::vector<TimedSegment> with_rest_around(std::vector<TimedSegment> segments) {
  const TimedSegment rest{.segment = Rest, .start = {}, .duration = duration_of(Rest)};
  if (segments.empty() || segments.front().segment != Rest) {
    segments.insert(segments.begin(), rest);
  }
  if (segments.back().segment != Rest) segments.push_back(rest);
  Milliseconds start{};
  for (auto& timed : segments) {
    timed.start = start;
    start += timed.duration;
  }
  return segments;
}

[[noreturn]] void refuse(std::string_view word, std::string_view finding, std::string_view remedy) {
  throw Error{fmt::format("\"{}\": {}; {}", word, finding, remedy)};
}

Stress stress_of(std::string_view symbol, const Segment& segment) {
  if (segment.is_ambiguous() || !is_vowel(segment.from)) return Stress::Primary;
  if (symbol.back() == '0') return Stress::None;
  return symbol.back() == '2' ? Stress::Secondary : Stress::Primary;
}

/// Where the duration's colon stands, the one of "B~W:3/8" left aside; npos if there is none.
std::size_t colon_of_duration(std::string_view word) {
  const auto slash = word.find('/');
  return word.find(
      ':', word.find('~') == std::string_view::npos || slash == std::string_view::npos ? 0 : slash);
}

TimedSegment typed_segment(const std::string& word) {
  const auto colon = colon_of_duration(word);
  const auto symbol = std::string_view{word}.substr(0, colon);
  const auto parsed = parse_segment(symbol);
  if (const auto* fault = std::get_if<SegmentFault>(&parsed)) {
    refuse(word, fault->finding, fault->remedy);
  }
  TimedSegment timed{.segment = std::get<Segment>(parsed)};
  timed.duration = duration_of(timed.segment, stress_of(symbol, timed.segment));
  if (colon != std::string::npos) {
    const auto text = std::string_view{word}.substr(colon + 1);
    double ms = 0;
    const auto* const end = text.data() + text.size();
    const auto [stopped, fault] = std::from_chars(text.data(), end, ms);
    const bool is_number = fault == std::errc{} && stopped == end && std::isfinite(ms);
    if (!is_number || ms <= 0 || ms > kLongestMs) {
      refuse(word,
             fmt::format("\"{}\" is no duration in ms above 0 and up to {}", text, kLongestMs),
             "write as \"S:140\"");
    }
    timed.duration = Milliseconds{ms};
  }
  return timed;
}

}  // namespace

IntrinsicDuration intrinsic_duration(Phone phone) {
  const auto& row = kDurations.at(static_cast<std::size_t>(phone));
  return {.shortest = Milliseconds{row.shortest_ms}, .inherent = Milliseconds{row.inherent_ms}};
}

IntrinsicDuration intrinsic_duration(const Segment& segment) {
  const auto from = intrinsic_duration(segment.from);
  const auto to = intrinsic_duration(segment.to);
  const double share = segment.share();
  return {.shortest = from.shortest + share * (to.shortest - from.shortest),
          .inherent = from.inherent + share * (to.inherent - from.inherent)};
}

Milliseconds duration_of(const Segment& segment, Stress stress) {
  const auto [shortest, inherent] = intrinsic_duration(segment);
  const Milliseconds unstressed = 0.7 * (inherent - shortest / 2) + shortest / 2;
  switch (stress) {
    case Stress::Primary:
      return inherent;
    case Stress::Secondary:
      return (inherent + unstressed) / 2;
    case Stress::None:
      return unstressed;
  }
  return inherent;
}

std::vector<TimedSegment> timed(std::span<const Segment> segments) {
  std::vector<TimedSegment> made;
  made.reserve(segments.size() + 2);
  for (const auto& segment : segments) {
    made.push_back({.segment = segment, .start = {}, .duration = duration_of(segment)});
  }
  return with_rest_around(std::move(made));
}

std::vector<TimedSegment> at_rate(std::vector<TimedSegment> segments, double rate) {
  for (auto& timed : segments) {
    timed.start /= rate;
    timed.duration /= rate;
  }
  return segments;
}

std::vector<TimedSegment> typed_segments(std::string_view text) {
  std::vector<TimedSegment> segments;
  std::istringstream words{std::string{text}};
  for (std::string word; words >> word;) segments.push_back(typed_segment(word));
  if (segments.empty()) {
    throw Error{"there are no segments in it; write as \"S T UW\" or \"S:140 T:60 UW1:200\""};
  }
  return with_rest_around(std::move(segments));
}

}  // namespace bimodal::synth

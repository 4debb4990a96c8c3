#include "synth/speech/claims.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace bimodal::synth {

namespace {

void append(std::vector<TimedSegment>& segments, const TimedSegment& timed) {
  const bool continues_rest =
      timed.segment == Phone::Rest && !segments.empty() && segments.back().segment == Phone::Rest;
  if (continues_rest) {
    segments.back().duration = timed.end() - segments.back().start;
  } else {
    segments.push_back(timed);
  }
}

void append_parts(std::vector<TimedSegment>& segments, const TimedSegment& timed) {
  const auto parts = face_segments(timed.segment);
  if (parts.size() == 1) {
    append(segments, {.segment = parts[0], .start = timed.start, .duration = timed.duration});
    return;
  }
  assert(parts.size() == 2);
  const Milliseconds first = timed.duration * kDiphthongSplit;
  append(segments, {.segment = parts[0], .start = timed.start, .duration = first});
  append(segments,
         {.segment = parts[1], .start = timed.start + first, .duration = timed.duration - first});
}

}  // namespace

std::vector<TimedSegment> segments_of(const Utterance& utterance) {
  std::vector<TimedSegment> segments;
  segments.reserve(utterance.phones.size());
  for (const auto& timed : utterance.phones) {
    append_parts(segments,
                 {.segment = timed.phone, .start = timed.start, .duration = timed.duration});
  }
  if (segments.empty()) segments.push_back({.segment = Phone::Rest});
  return segments;
}

std::vector<TimedSegment> face_segments(std::span<const TimedSegment> utterance) {
  std::vector<TimedSegment> segments;
  segments.reserve(utterance.size());
  for (const auto& timed : utterance) append_parts(segments, timed);
  if (segments.empty()) segments.push_back({.segment = Phone::Rest});
  return segments;
}

Claim claim_of(const SegmentTarget& asked, Milliseconds centre, std::size_t segment) {
  Claim claim{.peak = centre + asked.offset,
              .target = asked.target,
              .dominance = asked.dominance,
              .segment = segment};
  if (claim.dominance.inflection_ms != Dominance::kNoInflection) {
    const double from_peak = claim.dominance.inflection_ms + asked.offset.count();
    claim.dominance.inflection_ms = std::max(0.0, from_peak);
  }
  return claim;
}

std::vector<Claim> claims_on(Control control,
                             std::span<const TimedSegment> segments,
                             const SegmentTable& table) {
  std::vector<Claim> claims;
  claims.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto& timed = segments[i];
    const Milliseconds centre = timed.centre();
    if (timed.segment.is_ambiguous()) {
      claims.push_back(claim_of(table.at(timed.segment, control), centre, i));
    } else {
      claims.push_back(claim_of(table.at(timed.segment.from, control), centre, i));
    }
    if (timed.segment != Phone::Rest) continue;
    auto& rest = claims.back();
    const Milliseconds offset = rest.peak - centre;
    if (i == 0) {
      rest.dominance.theta_before = 0;
      rest.dominance.inflection_ms = Dominance::kNoInflection;
      rest.peak = timed.end() - kRestDistance + offset;
    }
    if (i + 1 == segments.size()) {
      rest.dominance.theta_after = 0;
      rest.peak = timed.start + kRestDistance + offset;
    }
  }
  return claims;
}

}  // namespace bimodal::synth

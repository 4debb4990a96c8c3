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

Claim claim_on(Control control,
               const TimedSegment& timed,
               std::size_t index,
               bool is_last,
               const SegmentTable& table) {
  const auto centre = timed.centre();
  if (timed.segment.is_ambiguous()) {
    return claim_of(table.at(timed.segment, control), centre, index);
  }
  Claim claim = claim_of(table.at(timed.segment.from, control), centre, index);
  if (timed.segment != Phone::Rest) return claim;
  const Milliseconds offset = claim.peak - centre;
  if (index == 0) {
    claim.dominance.theta_before = 0;
    claim.dominance.inflection_ms = Dominance::kNoInflection;
    claim.peak = timed.end() - kRestDistance + offset;
  }
  if (is_last) {
    claim.dominance.theta_after = 0;
    claim.peak = timed.start + kRestDistance + offset;
  }
  return claim;
}

std::vector<Claim> claims_on(Control control,
                             std::span<const TimedSegment> segments,
                             const SegmentTable& table) {
  std::vector<Claim> claims;
  claims.reserve(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    claims.push_back(claim_on(control, segments[i], i, i + 1 == segments.size(), table));
  }
  return claims;
}

}  // namespace bimodal::synth

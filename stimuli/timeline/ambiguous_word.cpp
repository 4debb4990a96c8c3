#include "stimuli/timeline/ambiguous_word.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

Pronunciation sounds(const Utterance& utterance) {
  Pronunciation phones;
  for (const auto& timed : utterance.phones) {
    if (timed.phone != Phone::Rest) phones.push_back(timed.phone);
  }
  return phones;
}

void refuse_other_number(const Utterance& utterance, std::span<const Segment> segments) {
  const auto said = sounds(utterance);
  if (said.size() == segments.size()) return;
  throw Error{fmt::format(
      "\"{}\" cannot be shown while \"{}\" is said: there are {} sounds for {} segments; give a "
      "segment for each sound",
      spell(segments),
      spell(said),
      said.size(),
      segments.size())};
}

}  // namespace

Pronunciation first_end(std::span<const Segment> segments) {
  Pronunciation phones;
  for (const auto& segment : segments) phones.push_back(segment.from);
  return phones;
}

Pronunciation last_end(std::span<const Segment> segments) {
  Pronunciation phones;
  for (const auto& segment : segments) phones.push_back(segment.to);
  return phones;
}

double mean_share(std::span<const Segment> segments) {
  double sum = 0;
  int count = 0;
  for (const auto& segment : segments) {
    if (!segment.is_ambiguous()) continue;
    sum += segment.share();
    ++count;
  }
  return count == 0 ? 0.0 : sum / count;
}

Utterance between(const Utterance& from, const Utterance& to, std::span<const Segment> segments) {
  refuse_other_number(from, segments);
  refuse_other_number(to, segments);
  const auto rests_alike = [](const TimedPhone& one, const TimedPhone& other) {
    return (one.phone == Phone::Rest) == (other.phone == Phone::Rest);
  };
  if (!std::ranges::equal(from.phones, to.phones, rests_alike)) {
    throw Error{
        fmt::format("\"{}\" has no times: the talker pauses elsewhere at one end than at the other",
                    spell(segments))};
  }
  const double mean = mean_share(segments);
  Utterance result;
  auto segment = segments.begin();
  for (std::size_t i = 0; i < from.phones.size(); ++i) {
    const bool is_rest = from.phones[i].phone == Phone::Rest;
    const double share = is_rest || !segment->is_ambiguous() ? mean : segment->share();
    const auto first = static_cast<double>(from.phones[i].duration.count());
    const auto last = static_cast<double>(to.phones[i].duration.count());
    result.phones.push_back({.phone = is_rest ? Phone::Rest : segment->nearer(),
                             .start = result.end(),
                             .duration = Duration{std::llround(std::lerp(first, last, share))}});
    if (!is_rest) ++segment;
  }
  return result;
}

std::vector<TimedSegment> articulated(const Utterance& utterance,
                                      std::span<const Segment> segments) {
  if (!segments.empty()) refuse_other_number(utterance, segments);
  std::vector<TimedSegment> articulation;
  auto segment = segments.begin();
  for (const auto& timed : utterance.phones) {
    const bool is_kept = segments.empty() || timed.phone == Phone::Rest;
    articulation.push_back({.segment = is_kept ? Segment{timed.phone} : *segment++,
                            .start = timed.start,
                            .duration = timed.duration});
  }
  return articulation;
}

}  // namespace bimodal

#pragma once

#include <span>
#include <vector>

#include "stimuli/timeline/segment.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

/// The phones of the first (or last) end of every segment: "B~W:3/8 AA" lies between B AA and W AA.
[[nodiscard]] Pronunciation first_end(std::span<const Segment> segments);
[[nodiscard]] Pronunciation last_end(std::span<const Segment> segments);

/// When an ambiguous word is said, from how its two ends are said: the duration of each ambiguous
/// segment in proportion, those of the other sounds and of rests by the mean share of the ambiguous
/// ones. The phones are the nearer ones. Throws Error unless both utterances have as many sounds as
/// there are segments, and rests at the same places.
[[nodiscard]] Utterance between(const Utterance& from,
                                const Utterance& to,
                                std::span<const Segment> segments);

/// How far the word as a whole is from its first end: the mean share of its ambiguous segments; 0
/// if there are none.
[[nodiscard]] double mean_share(std::span<const Segment> segments);

/// What a face does when `utterance` is said: its sounds are replaced, in order, by `segments`; as
/// it is if there are none. Throws Error, with both, if their numbers differ.
[[nodiscard]] std::vector<TimedSegment> articulated(const Utterance& utterance,
                                                    std::span<const Segment> segments);

}  // namespace bimodal

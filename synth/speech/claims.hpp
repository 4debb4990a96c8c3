#pragma once

#include <span>
#include <vector>

#include "stimuli/timeline/segment.hpp"
#include "stimuli/timeline/utterance.hpp"
#include "synth/speech/control.hpp"
#include "synth/speech/dominance.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::synth {

/// The rest before and after speech has its peak this far outside of it (the fit to natural lips
/// that the dynamics come from was made so).
inline constexpr Milliseconds kRestDistance{100};

/// The first segment of a diphthong lasts this part of it (as in the fit to natural lips).
inline constexpr double kDiphthongSplit = 0.55;

/// The segments of the face that an utterance stands for: each phone, diphthongs as their two
/// halves, neighbouring rests as one. An utterance without phones is one rest.
[[nodiscard]] std::vector<TimedSegment> segments_of(const Utterance& utterance);

/// The same for an utterance of segments, some of which may be ambiguous.
[[nodiscard]] std::vector<TimedSegment> face_segments(std::span<const TimedSegment> utterance);

/// The claims that `segments` make on one control, in their order: peak t_c + t_o, where t_c is the
/// segment's centre. A rest at either end is special: its t_c lies
/// kRestDistance outside the speech, whatever its duration, and its dominance is constant from its
/// peak outwards, so that the length of a pause does not change the movement. Precondition: no
/// segment is a diphthong.
[[nodiscard]] std::vector<Claim> claims_on(Control control,
                                           std::span<const TimedSegment> segments,
                                           const SegmentTable& table);

/// The claim of one of them: the first has index 0.
[[nodiscard]] Claim claim_on(Control control,
                             const TimedSegment& timed,
                             std::size_t index,
                             bool is_last,
                             const SegmentTable& table);

/// The claim that a segment makes which asks for `asked`: t_c is the middle of the segment, and a
/// change of theta is counted from there.
[[nodiscard]] Claim claim_of(const SegmentTarget& asked, Milliseconds centre, std::size_t segment);

}  // namespace bimodal::synth

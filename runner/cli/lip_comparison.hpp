#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runner/cli/labelled_track.hpp"
#include "synth/face/head.hpp"
#include "synth/fitting/agreement.hpp"
#include "synth/fitting/lip_timing.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::runner {

/// The measures of the project's own head that stand for measured ones, under their names: inner_h,
/// outer_w, outer_h, inner_area, chin_drop. (The measured inner_w is the distance of the inner
/// corners of the lips, which stays where lips shut; the head's is the width of the opening.) Of
/// chin_drop only the movement around its mean is compared.
[[nodiscard]] std::vector<std::string> face_measures();

/// The head says an utterance: its measures 100 times a second, from 300 ms before the speech to
/// 300 ms behind it.
[[nodiscard]] synth::Track face_track(const Utterance& utterance,
                                      const synth::SegmentTable& segments,
                                      const synth::Head& head);

/// One measure at one phone's centre. Positions are relative to the mean over all instants that
/// were compared, each talker's own.
struct PhoneValue {
  Phone phone = Phone::Rest;
  double measured = 0;
  double predicted = 0;
};

struct MeasureComparison {
  std::string measure;
  synth::Agreement agreement;
  std::vector<PhoneValue> phones;
};

/// The closures of a clip, or its roundings, as measured and as predicted. What one of them does
/// not have is absent.
template <typename Event>
struct EventPair {
  TimedPhone phone;
  std::optional<Event> measured;
  std::optional<Event> predicted;
};

/// How one recording's measures compare with predicted ones.
struct ClipComparison {
  std::string clip;
  std::vector<MeasureComparison> measures;
  std::vector<EventPair<synth::Closure>> closures;
  std::vector<EventPair<synth::Rounding>> roundings;
};

/// Compares the columns that both have, at the instants of the recording from 100 ms before the
/// speech to 100 ms behind it which the prediction covers. Closures need inner_h, roundings
/// outer_w. Throws Error if they have no column in common or fewer than five instants.
[[nodiscard]] ClipComparison compare(const LabelledTrack& recording, const synth::Track& predicted);

}  // namespace bimodal::runner

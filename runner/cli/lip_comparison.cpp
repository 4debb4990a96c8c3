#include "runner/cli/lip_comparison.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "synth/fitting/measured_clip.hpp"
#include "synth/speech/articulation.hpp"

namespace bimodal::runner {

namespace {

constexpr double kStepMs = 10;
constexpr double kAroundMs = 300;
constexpr std::size_t kFewestInstants = 5;
/// Talkers' chins are measured from the nose, the head's from its place at rest: of this measure
/// only the movement is compared.
constexpr std::string_view kChinDrop = "chin_drop";
constexpr double kLeastMeasuredFall = 1.5;   // mm, as in the fit to natural lips
constexpr double kLeastPredictedFall = 0.5;  // mm

struct FaceMeasure {
  std::string_view name;
  double synth::LipMeasures::*value;
};

constexpr std::array<FaceMeasure, 5> kFaceMeasures{{
    {"inner_h", &synth::LipMeasures::inner_height_mm},
    {"outer_w", &synth::LipMeasures::outer_width_mm},
    {"outer_h", &synth::LipMeasures::outer_height_mm},
    {"inner_area", &synth::LipMeasures::inner_area_mm2},
    {kChinDrop, &synth::LipMeasures::chin_drop_mm},
}};

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Whether a track tells a value for this instant.
bool covers(const synth::Track& track, double time_ms) {
  return time_ms >= track.time_ms.front() && time_ms <= track.time_ms.back();
}

MeasureComparison compare_measure(const LabelledTrack& recording,
                                  const synth::TrackColumn& measured,
                                  const synth::Track& other,
                                  const synth::TrackColumn& predicted) {
  const auto clip = synth::measured_clip(
      recording.name, recording.track, measured, recording.utterance, recording.labels, false);
  std::vector<double> one;
  std::vector<double> two;
  for (std::size_t i = 0; i < clip.time_ms.size(); ++i) {
    if (!covers(other, clip.time_ms[i])) continue;
    one.push_back(clip.values[i]);
    two.push_back(interpolated(other, predicted, clip.time_ms[i]));
  }
  if (one.size() < kFewestInstants) {
    throw Error{
        fmt::format("{}: has {} instants within the speech of '{}'; give the prediction of "
                    "the same recording, counted from its start",
                    other.file,
                    one.size(),
                    recording.name)};
  }
  const bool relative = synth::kind_of(measured.name) == synth::MeasureKind::Position;
  const double measured_mean = relative ? mean(one) : 0;
  const double predicted_mean = relative ? mean(two) : 0;
  if (measured.name == kChinDrop) {
    for (double& value : one) value -= measured_mean;
    for (double& value : two) value -= predicted_mean;
  }
  MeasureComparison found{.measure = measured.name, .agreement = synth::agreement(two, one)};
  for (const auto& timed : recording.utterance.phones) {
    const double centre = (Milliseconds{timed.start} + Milliseconds{timed.duration} / 2).count();
    if (timed.phone == Phone::Rest || !covers(recording.track, centre) || !covers(other, centre)) {
      continue;
    }
    found.phones.push_back(
        {.phone = timed.phone,
         .measured = interpolated(recording.track, measured, centre) - measured_mean,
         .predicted = interpolated(other, predicted, centre) - predicted_mean});
  }
  return found;
}

synth::Course course_of(const synth::Track& track, const synth::TrackColumn& column) {
  return {.time_ms = track.time_ms, .values = column.values};
}

}  // namespace

std::vector<std::string> face_measures() {
  std::vector<std::string> names;
  for (const auto& measure : kFaceMeasures) names.emplace_back(measure.name);
  return names;
}

synth::Track face_track(const Utterance& utterance,
                        const synth::SegmentTable& segments,
                        const synth::Head& head) {
  synth::Track track{.file = "the face", .time_ms = {}, .columns = {}};
  for (const auto& name : face_measures()) track.columns.push_back({.name = name, .values = {}});
  const synth::Articulation articulation{utterance, segments};
  const auto speech = speech_interval(utterance);
  const double end = Milliseconds{speech.end}.count() + kAroundMs;
  synth::PosedHead posed;
  double time = std::max(0.0, Milliseconds{speech.start}.count() - kAroundMs);
  for (; time <= end; time += kStepMs) {
    head.pose(articulation.at(Milliseconds{time}), posed);
    track.time_ms.push_back(time);
    for (std::size_t i = 0; i < kFaceMeasures.size(); ++i) {
      track.columns[i].values.push_back(posed.lips.*kFaceMeasures.at(i).value);
    }
  }
  return track;
}

ClipComparison compare(const LabelledTrack& recording, const synth::Track& predicted) {
  ClipComparison found{.clip = recording.name, .measures = {}, .closures = {}, .roundings = {}};
  for (const auto& measured : recording.track.columns) {
    if (const auto* const other = predicted.column(measured.name)) {
      found.measures.push_back(compare_measure(recording, measured, predicted, *other));
    }
  }
  if (found.measures.empty()) {
    throw Error{fmt::format("{} and {} have no measure in common; name the columns alike",
                            recording.track.file,
                            predicted.file)};
  }
  const auto* const heights = recording.track.column("inner_h");
  const auto* const told_heights = predicted.column("inner_h");
  const auto* const widths = recording.track.column("outer_w");
  const auto* const told_widths = predicted.column("outer_w");
  for (const auto& timed : recording.utterance.phones) {
    if (synth::closes_lips(timed.phone) && heights != nullptr && told_heights != nullptr) {
      found.closures.push_back(
          {.phone = timed,
           .measured = synth::closure(course_of(recording.track, *heights), timed),
           .predicted = synth::closure(course_of(predicted, *told_heights), timed)});
    }
    if (synth::rounds_lips(timed.phone) && widths != nullptr && told_widths != nullptr) {
      found.roundings.push_back(
          {.phone = timed,
           .measured =
               synth::rounding(course_of(recording.track, *widths), timed, kLeastMeasuredFall),
           .predicted =
               synth::rounding(course_of(predicted, *told_widths), timed, kLeastPredictedFall)});
    }
  }
  return found;
}

}  // namespace bimodal::runner

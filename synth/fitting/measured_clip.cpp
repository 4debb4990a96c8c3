#include "synth/fitting/measured_clip.hpp"

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::synth {

namespace {

constexpr std::size_t kFewestInstants = 5;
constexpr double kRounding = 1e-6;  // ms

}  // namespace

MeasureKind kind_of(std::string_view column) {
  const bool opens = column.starts_with("inner_h") || column.starts_with("inner_area");
  return opens ? MeasureKind::Opening : MeasureKind::Position;
}

MeasuredClip measured_clip(const std::string& name,
                           const Track& track,
                           const TrackColumn& column,
                           const Utterance& utterance,
                           const std::string& labels,
                           bool relative) {
  const auto speech = speech_interval(utterance);
  MeasuredClip clip{.name = name,
                    .spoken = spoken_parts(utterance),
                    .speech_start_ms = Milliseconds{speech.start}.count(),
                    .speech_end_ms = Milliseconds{speech.end}.count()};
  if (clip.spoken.empty()) {
    throw Error{fmt::format("{}: no phone is spoken in it; give the labels of '{}'", labels, name)};
  }
  const double first = clip.speech_start_ms - kMargin.count() - kRounding;
  const double last = clip.speech_end_ms + kMargin.count() + kRounding;
  double sum = 0;
  std::size_t spoken = 0;
  for (std::size_t i = 0; i < track.time_ms.size(); ++i) {
    const double time = track.time_ms[i];
    if (time < first || time > last) continue;
    clip.time_ms.push_back(time);
    clip.values.push_back(column.values[i]);
    if (time < clip.speech_start_ms || time >= clip.speech_end_ms) continue;
    sum += column.values[i];
    ++spoken;
  }
  if (spoken == 0 || clip.time_ms.size() < kFewestInstants) {
    throw Error{
        fmt::format("{}: the speech of '{}' lasts from {:.3f} to {:.3f} s, and the track from "
                    "{:.3f} to {:.3f} s has {} instants there; give labels and track of the same "
                    "recording, both counted from its start",
                    track.file,
                    labels,
                    clip.speech_start_ms / 1e3,
                    clip.speech_end_ms / 1e3,
                    track.time_ms.front() / 1e3,
                    track.time_ms.back() / 1e3,
                    clip.time_ms.size())};
  }
  if (relative) clip.reference = sum / static_cast<double>(spoken);
  for (double& value : clip.values) value -= clip.reference;
  return clip;
}

double coverage(const MeasuredClip& clip) {
  const double window = clip.speech_end_ms - clip.speech_start_ms + 2 * kMargin.count();
  const auto instants = static_cast<double>(clip.time_ms.size());
  const double step = (clip.time_ms.back() - clip.time_ms.front()) / (instants - 1);
  return std::min(1.0, instants * step / window);
}

}  // namespace bimodal::synth

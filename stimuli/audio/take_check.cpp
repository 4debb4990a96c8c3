#include "stimuli/audio/take_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "stimuli/audio/band.hpp"
#include "stimuli/audio/speech_detector.hpp"

namespace bimodal {

namespace {

constexpr float kFullScale = 0.999F;  ///< 16-bit samples end a little below 1

struct FaultText {
  TakeFault fault;
  std::string_view name;
  std::string_view advice;
};

constexpr std::array<FaultText, 7> kFaults{{
    {TakeFault::Nothing, "nothing", "Nothing was heard: say the word while the dot is red."},
    {TakeFault::Gaps, "gaps", "The computer has lost some of the sound: once more, please."},
    {TakeFault::Clipped, "clipped", "Too loud: move back a little, or speak more softly."},
    {TakeFault::Quiet, "quiet", "Too quiet: come closer to the microphone, or speak up."},
    {TakeFault::Noisy,
     "noisy",
     "The room is too loud for your voice: come closer, or wait until it is quiet."},
    {TakeFault::BegunEarly, "begun_early", "Begun too early: wait for the red dot."},
    {TakeFault::CutOff, "cut_off", "Cut off at the end: wait until the red dot has gone."},
}};

const FaultText& text_of(TakeFault fault) {
  return kFaults.at(static_cast<std::size_t>(fault));
}

/// The samples from `interval.start` to `interval.end`, as far as there are any.
std::span<const float> part_of(const Clip& take, const SpeechInterval& interval) {
  const auto at = [&](Duration time) {
    const auto sample = static_cast<std::size_t>(nearest_sample(time, take.rate).count());
    return std::min(sample, take.samples.size());
  };
  const auto first = at(interval.start);
  return std::span{take.samples}.subspan(first, at(interval.end) - first);
}

Clip without_rumble(const Clip& take) {
  Clip filtered{take.rate, {}};
  filtered.samples.reserve(take.samples.size());
  RumbleFilter filter{take.rate};
  for (const float sample : take.samples) {
    filtered.samples.push_back(static_cast<float>(filter(sample)));
  }
  return filtered;
}

}  // namespace

TakeMeasures measure_take(const Clip& take, Decibels room) {
  SpeechDetector detector{take.rate, room};
  detector.feed(take.samples);
  TakeMeasures measures{.duration = take.duration(), .speech = detector.speech()};
  const auto judged = measures.speech.value_or(SpeechInterval{{}, measures.duration});
  measures.level = level(part_of(take, judged));
  measures.snr = level(part_of(without_rumble(take), judged)) - room;
  float largest = 0.0F;
  for (const float sample : take.samples) {
    const float size = std::abs(sample);
    largest = std::max(largest, size);
    if (size >= kFullScale) ++measures.clipped;
  }
  measures.peak = decibels(static_cast<double>(largest));
  return measures;
}

std::string_view name(TakeFault fault) {
  return text_of(fault).name;
}

std::optional<TakeFault> take_fault(std::string_view name) {
  const auto* const found = std::ranges::find(kFaults, name, &FaultText::name);
  if (found == kFaults.end()) return std::nullopt;
  return found->fault;
}

std::string_view advice(TakeFault fault) {
  return text_of(fault).advice;
}

std::vector<TakeFault> faults_of(const TakeMeasures& measures,
                                 std::int64_t lost,
                                 const TakeRules& rules) {
  std::vector<TakeFault> faults;
  const auto note = [&](bool is_found, TakeFault fault) {
    if (is_found) faults.push_back(fault);
  };
  note(!measures.speech, TakeFault::Nothing);
  note(lost > 0, TakeFault::Gaps);
  if (!measures.speech) return faults;
  note(measures.clipped > 0, TakeFault::Clipped);
  note(measures.peak < rules.lowest_peak, TakeFault::Quiet);
  note(measures.snr < rules.lowest_snr, TakeFault::Noisy);
  note(measures.speech->start < rules.margin, TakeFault::BegunEarly);
  note(measures.duration - measures.speech->end < rules.margin, TakeFault::CutOff);
  return faults;
}

}  // namespace bimodal

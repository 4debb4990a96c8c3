#include "runner/preparation/trial_preparer.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

using protocols::Condition;
using protocols::PlannedTrial;

SoundRecord record_of(const Mix& mix) {
  return {.sha256 = sha256(mix.sound),
          .rate_hz = static_cast<int>(std::lround(mix.sound.rate.count())),
          .samples = static_cast<std::int64_t>(mix.sound.samples.size()),
          .speech_dbfs = mix.speech_dbfs,
          .noise_dbfs = mix.noise_dbfs,
          .band_low_hz = mix.band.low.count(),
          .band_high_hz = mix.band.high.count(),
          .peak = mix.peak,
          .speech_start = mix.speech.start,
          .speech_end = mix.speech.end};
}

}  // namespace

std::string clipping_message(const PlannedTrial& trial,
                             const std::string& condition,
                             const Mix& mix) {
  const auto lacking = headroom_lacking(mix);
  if (!lacking) return {};
  return fmt::format(
      "the sound of trial {} (\"{}\", condition \"{}\") would clip: its peak is {:.2f} of full "
      "scale, "
      "{:.1f} dB of headroom lacking; lower /sound/speech_level_dbfs by at least that much",
      trial.index + 1,
      trial.word.spelling,
      condition,
      mix.peak,
      lacking->count());
}

TrialPreparer::TrialPreparer(const protocols::Protocol& protocol,
                             SpeechBank& bank,
                             FaceTalker* face,
                             Hertz drawing_rate)
    : protocol_{protocol}, bank_{bank}, face_{face}, drawing_rate_{drawing_rate} {}

const synth::SpokenItem& TrialPreparer::spoken(const PlannedTrial& trial) {
  const Condition& condition = protocol_.conditions.at(trial.condition);
  return bank_.item(condition.auditory_talker.value_or(condition.timing_talker), trial.word);
}

std::optional<Mix> TrialPreparer::mix_sound(const PlannedTrial& trial) {
  const Condition& condition = protocol_.conditions.at(trial.condition);
  if (!condition.auditory_talker) return std::nullopt;
  const auto& item = spoken(trial);
  const auto& noise = protocol_.sound.noise;
  const auto known = levels_.find(&item);
  const auto level = known != levels_.end() ? std::optional{known->second} : std::nullopt;
  auto mixed = mix({.speech = &item.sound,
                    .interval = speech_interval(item.utterance),
                    .snr = condition.snr,
                    .speech_level = protocol_.sound.speech_level,
                    .band = {.low = noise.band_low, .high = noise.band_high},
                    .lead = noise.lead,
                    .trail = noise.trail,
                    .ramp = noise.ramp,
                    .noise_seed = trial.noise_seed,
                    .recording_level = level},
                   fourier_);
  if (mixed) levels_[&item] = mixed->recording_level;
  return mixed;
}

PreparedTrial TrialPreparer::prepare(const PlannedTrial& trial, const Checkpoint& checkpoint) {
  const Condition& condition = protocol_.conditions.at(trial.condition);
  const auto& item = spoken(trial);
  PreparedTrial prepared{.plan = trial,
                         .layout = {.recording = item.sound.duration(),
                                    .lead = protocol_.intervals.lead,
                                    .trail = protocol_.intervals.trail,
                                    .sound_lead = protocol_.sound.noise.lead,
                                    .sound_trail = protocol_.sound.noise.trail,
                                    .av_offset = protocol_.intervals.av_offset,
                                    .has_sound = condition.auditory_talker.has_value()},
                         .drawing_rate = drawing_rate_};
  if (auto mixed = mix_sound(trial)) {
    const auto clipping = clipping_message(trial, condition.name, *mixed);
    if (!clipping.empty()) throw Error{clipping};
    prepared.sound_record = record_of(*mixed);
    prepared.sound = Sound{
        .rate = mixed->sound.rate,
        .samples = std::make_shared<const std::vector<float>>(std::move(mixed->sound.samples))};
  }
  if (condition.visual_talker) {
    prepared.frames = frame_count(prepared.layout, drawing_rate_);
    if (face_ != nullptr) {
      const auto source = face_->say(item.utterance);
      prepared.film = make_film(prepared.layout, drawing_rate_, *source, checkpoint);
    }
  }
  return prepared;
}

}  // namespace bimodal::runner

#include "runner/preparation/trial_preparer.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "runner/preparation/sound_channels.hpp"
#include "stimuli/audio/time_scale.hpp"
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

/// The sound falls silent over this time before a gate.
constexpr Duration kGateRamp = std::chrono::milliseconds{5};

std::vector<RecordingRecord> recordings_of(const Enactment& enactment, const Condition& condition) {
  std::vector<RecordingRecord> records;
  const auto add = [&](const char* modality,
                       const std::optional<RecordedSource>& source,
                       const std::optional<std::string>& talker) {
    if (!source || !talker) return;
    records.push_back({.modality = modality,
                       .talker = *talker,
                       .item = source->item,
                       .file = source->file,
                       .sha256 = source->sha256,
                       .start = source->span.start,
                       .end = source->span.end});
  };
  add("auditory", enactment.sound_source, condition.auditory_talker);
  add("visual", enactment.picture_source, condition.visual_talker);
  return records;
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
      shown_name(trial.word),
      condition,
      mix.peak,
      lacking->count());
}

TrialPreparer::TrialPreparer(const protocols::Protocol& protocol,
                             Repertoire& repertoire,
                             FilmStudio* studio,
                             Hertz drawing_rate)
    : protocol_{protocol}, repertoire_{repertoire}, studio_{studio}, drawing_rate_{drawing_rate} {}

TrialPreparer::Kept& TrialPreparer::kept(const PlannedTrial& trial) {
  const Condition& condition = protocol_.conditions.at(trial.condition);
  const auto key =
      fmt::format("{} {} {}", trial.condition, shown_name(trial.word), spell(trial.word.phones));
  const auto found = kept_.find(key);
  if (found != kept_.end()) return found->second;
  return kept_.emplace(key, Kept{enact(condition, trial.word, repertoire_), std::nullopt})
      .first->second;
}

std::optional<Mix> TrialPreparer::mix_sound(const PlannedTrial& trial) {
  const Condition& condition = protocol_.conditions.at(trial.condition);
  auto& known = kept(trial);
  if (!condition.auditory_talker) return std::nullopt;
  const auto& noise = protocol_.sound.noise;
  MixRequest request{.speech = known.enactment.sound.get(),
                     .interval = speech_interval(known.enactment.heard),
                     .snr = condition.snr,
                     .speech_level = protocol_.sound.speech_level,
                     .band = {.low = noise.band_low, .high = noise.band_high},
                     .lead = noise.lead,
                     .trail = noise.trail,
                     .ramp = noise.ramp,
                     .noise_seed = trial.noise_seed,
                     .recording_level = known.level};
  std::optional<Clip> cut_off;
  if (known.enactment.gate) {
    if (!known.level) {  // the level is that of the whole word, wherever the gate falls
      auto whole = request;
      whole.snr.reset();
      request.recording_level = known.level = mix(whole, fourier_)->recording_level;
    }
    cut_off = gated(*known.enactment.sound, *known.enactment.gate, kGateRamp);
    request.speech = &*cut_off;
  }
  auto mixed = mix(request, fourier_);
  if (mixed) known.level = mixed->recording_level;
  return mixed;
}

StimulusLayout TrialPreparer::layout_of(const Condition& condition,
                                        const Enactment& enactment) const {
  return {.recording = enactment.length,
          .lead = protocol_.intervals.lead,
          .trail = protocol_.intervals.trail,
          .sound_lead = protocol_.sound.noise.lead,
          .sound_trail = protocol_.sound.noise.trail,
          .av_offset = condition.av_offset.value_or(protocol_.intervals.av_offset),
          .has_sound = condition.auditory_talker.has_value()};
}

std::optional<std::uintmax_t> TrialPreparer::kept_film_bytes(const PlannedTrial& trial) {
  const Condition& condition = protocol_.conditions.at(trial.condition);
  if (!condition.visual_talker || studio_ == nullptr) return 0;
  const auto& enactment = kept(trial).enactment;
  return studio_->kept_bytes(condition, enactment, layout_of(condition, enactment), drawing_rate_);
}

PreparedTrial TrialPreparer::prepare(const PlannedTrial& trial, const Checkpoint& checkpoint) {
  const Condition& condition = protocol_.conditions.at(trial.condition);
  const auto& enactment = kept(trial).enactment;
  PreparedTrial prepared{.plan = trial,
                         .layout = layout_of(condition, enactment),
                         .drawing_rate = drawing_rate_,
                         .recordings = recordings_of(enactment, condition),
                         .offset_tolerance = protocol_.timing.offset_tolerance};
  if (auto mixed = mix_sound(trial)) {
    const auto clipping = clipping_message(trial, condition.name, *mixed);
    if (!clipping.empty()) throw Error{clipping};
    prepared.sound_record = record_of(*mixed);
    prepared.sound = Sound{
        .rate = mixed->sound.rate,
        .samples = std::make_shared<const std::vector<float>>(std::move(mixed->sound.samples)),
        .channels = stimulus_channels(protocol_.sound),
        .marker = click_marker(protocol_, prepared.layout.sound_lead)};
    prepared.sound->silent_head = count_silent_head(*prepared.sound);
  }
  if (condition.visual_talker) {
    prepared.frames = frame_count(prepared.layout, drawing_rate_);
    if (studio_ != nullptr) {
      prepared.film =
          studio_->film(condition, enactment, prepared.layout, drawing_rate_, checkpoint);
    }
  }
  return prepared;
}

}  // namespace bimodal::runner

#include "runner/preparation/enactment.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "protocols/model/talker.hpp"
#include "stimuli/audio/release.hpp"
#include "stimuli/audio/time_scale.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/timeline/ambiguous_word.hpp"

namespace bimodal::runner {

namespace {

/// The same phones later, with rest before and after up to `length`.
Utterance placed(const Utterance& utterance, Duration start, Duration length) {
  Utterance result;
  const auto add = [&result](Phone phone, Duration duration) {
    if (duration <= Duration{}) return;
    auto& phones = result.phones;
    const bool goes_on = phone == Phone::Rest && !phones.empty() && phones.back().phone == phone;
    if (goes_on) {
      phones.back().duration += duration;
    } else {
      phones.push_back({phone, result.end(), duration});
    }
  };
  add(Phone::Rest, start);
  for (const auto& timed : utterance.phones) add(timed.phone, timed.duration);
  add(Phone::Rest, length - start - utterance.end());
  return result;
}

/// The same sound later, with silence before and after up to `length`.
Clip placed(const Clip& sound, Duration start, Duration length) {
  Clip result{.rate = sound.rate, .samples = {}};
  const auto whole = static_cast<std::size_t>(nearest_sample(length, sound.rate).count());
  const auto before = static_cast<std::size_t>(nearest_sample(start, sound.rate).count());
  result.samples.assign(std::max(whole, before + sound.samples.size()), 0.0F);
  std::ranges::copy(sound.samples, result.samples.begin() + static_cast<std::ptrdiff_t>(before));
  return result;
}

std::shared_ptr<const Clip> borrowed(const Clip& sound) {
  return {std::shared_ptr<const Clip>{}, &sound};
}

/// Who times what is seen.
const std::string& talker_seen(const protocols::Condition& condition) {
  const bool natural = condition.visual_talker && protocols::is_corpus(*condition.visual_talker);
  return natural ? *condition.visual_talker : condition.timing_talker;
}

void refuse_silent(const Performance& performance, const Word& word) {
  if (!performance.sound.samples.empty()) return;
  throw Error{fmt::format("\"{}\" cannot be heard: the recording '{}' has no sound",
                          word.spelling,
                          performance.source ? performance.source->file : std::string{})};
}

Duration release_of(const Performance& performance) {
  if (performance.release) return *performance.release;
  return bimodal::release_of(performance.sound, performance.utterance);
}

void bring_together(const Performance* heard, const Performance& seen, Enactment& enactment) {
  if (heard == nullptr || heard == &seen) {
    enactment.length = seen.sound.samples.empty() ? seen.length() : seen.sound.duration();
    enactment.seen = seen.utterance;
    if (heard == nullptr) return;
    enactment.heard = seen.utterance;
    enactment.sound = borrowed(seen.sound);
    return;
  }
  const auto heard_release = release_of(*heard);
  const auto seen_release = release_of(seen);
  const Duration start =
      heard_release - seen_release;  // of what is seen, when the sound begins at 0
  const Duration heard_start = std::max(Duration{}, -start);
  const Duration seen_start = std::max(Duration{}, start);
  enactment.length = std::max(heard_start + heard->sound.duration(), seen_start + seen.length());
  const auto sound =
      std::make_shared<const Clip>(placed(heard->sound, heard_start, enactment.length));
  enactment.length = sound->duration();
  enactment.sound = sound;
  enactment.heard = placed(heard->utterance, heard_start, enactment.length);
  enactment.seen = placed(seen.utterance, seen_start, enactment.length);
  enactment.picture_start = seen_start;
  enactment.release = heard_start + heard_release;
}

void change_manner(const protocols::Manner& manner, Enactment& enactment) {
  enactment.rate = manner.rate;
  enactment.reversed = manner.reversed;
  if (manner.rate != 1.0) {
    enactment.heard = change_rate(enactment.heard, manner.rate);
    enactment.seen = change_rate(enactment.seen, manner.rate);
    enactment.length =
        Duration{std::llround(static_cast<double>(enactment.length.count()) / manner.rate)};
    if (enactment.sound) {
      enactment.sound = std::make_shared<const Clip>(change_rate(*enactment.sound, manner.rate));
      enactment.length = enactment.sound->duration();
    }
    if (enactment.release) {
      enactment.release =
          Duration{std::llround(static_cast<double>(enactment.release->count()) / manner.rate)};
    }
  }
  if (!manner.reversed) return;
  enactment.heard = reversed(enactment.heard);
  enactment.seen = reversed(enactment.seen);
  if (enactment.sound) enactment.sound = std::make_shared<const Clip>(reversed(*enactment.sound));
  if (enactment.release) enactment.release = enactment.length - *enactment.release;
}

Duration gate_instant(const protocols::Gate& gate, const Utterance& utterance, const Word& word) {
  const auto speech = speech_interval(utterance);
  if (gate.at) return speech.start + *gate.at;
  int spoken = 0;
  for (const auto& timed : utterance.phones) {
    if (timed.phone != Phone::Rest && ++spoken == gate.after_phone) return timed.end();
  }
  throw Error{fmt::format(
      "\"{}\" cannot be gated after phone {}: it has {}", word.spelling, gate.after_phone, spoken)};
}

}  // namespace

Enactment enact(const protocols::Condition& condition, const Word& word, Repertoire& repertoire) {
  const SeenWord same{word.spelling, word.phones, word.articulation};
  const auto& word_seen = word.seen ? *word.seen : same;
  const bool natural = condition.visual_talker && protocols::is_corpus(*condition.visual_talker);
  const Performance* heard = nullptr;
  if (condition.auditory_talker) {
    heard = &repertoire.perform(*condition.auditory_talker, word.spelling, word.phones);
    refuse_silent(*heard, word);
  }
  // What is heard times the face, unless another word is seen or another talker.
  const bool is_timed_by_voice =
      !condition.visual_talker ||
      (heard != nullptr && !word.seen && talker_seen(condition) == *condition.auditory_talker);
  const auto& seen =
      is_timed_by_voice ? *heard : repertoire.perform(talker_seen(condition), word_seen);
  Enactment enactment;
  bring_together(heard, seen, enactment);
  if (heard != nullptr) enactment.sound_source = heard->source;
  if (natural) enactment.picture_source = seen.source;
  change_manner(condition.manner, enactment);
  if (condition.visual_talker && !natural) {
    auto segments = word_seen.articulation;
    if (enactment.reversed) std::ranges::reverse(segments);
    enactment.articulation = articulated(enactment.seen, segments);
  }
  if (condition.manner.gate) {
    enactment.gate = gate_instant(
        *condition.manner.gate, heard != nullptr ? enactment.heard : enactment.seen, word);
    if (*enactment.gate >= enactment.length) {
      throw Error{
          fmt::format("the gate of \"{}\" lies behind its end: {} ms of {} ms; set it earlier",
                      shown_name(word),
                      std::chrono::round<std::chrono::milliseconds>(*enactment.gate).count(),
                      std::chrono::round<std::chrono::milliseconds>(enactment.length).count())};
    }
  }
  return enactment;
}

Duration recording_time(const Enactment& enactment, Duration time) {
  const Duration onward = enactment.reversed ? enactment.length - time : time;
  const Duration natural{std::llround(static_cast<double>(onward.count()) * enactment.rate)};
  return natural - enactment.picture_start + enactment.picture_source->span.start;
}

}  // namespace bimodal::runner

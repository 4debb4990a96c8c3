#include "synth/voice/spoken_item.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stimuli/base/error.hpp"
#include "stimuli/timeline/festival_phones.hpp"

namespace bimodal::synth {

namespace {

constexpr float kFullScale = 32'768;

Duration from_seconds(double seconds) {
  return Duration{std::llround(seconds * 1e9)};
}

std::string symbols_of(const FestivalSpeech& speech) {
  std::string text;
  for (const auto& segment : speech.segments) text += segment.symbol + ' ';
  return text;
}

Utterance labelled(const FestivalSpeech& speech) {
  Utterance utterance;
  Duration start{};
  for (const auto& segment : speech.segments) {
    const auto phones = phones_from_festival(segment.symbol);
    const Duration end = from_seconds(segment.end_s);
    if (phones.empty() || end <= start) {
      throw Error{
          fmt::format("Festival gave the segment '{}' ending at {} s after {} s, which is not"
                      " a phone of English with a duration",
                      segment.symbol,
                      segment.end_s,
                      std::chrono::duration<double>{start}.count())};
    }
    const Duration part = (end - start) / static_cast<Duration::rep>(phones.size());
    for (const Phone phone : phones) {
      const bool last = phone == phones.back();
      const Duration duration = last ? end - start : part;
      utterance.phones.push_back({.phone = phone, .start = start, .duration = duration});
      start += duration;
    }
  }
  return utterance;
}

bool is_rest(const TimedPhone& timed) {
  return timed.phone == Phone::Rest;
}

/// The segments between the rests at the ends renamed to the phones asked for.
void rename(Utterance& utterance,
            const FestivalSpeech& speech,
            std::span<const Phone> pronunciation) {
  auto& phones = utterance.phones;
  const bool same_length =
      phones.size() == speech.segments.size() && phones.size() == pronunciation.size() + 2;
  bool same = same_length;
  for (std::size_t i = 0; same && i < pronunciation.size(); ++i) {
    same = realises(speech.segments[i + 1].symbol, pronunciation[i]);
    phones[i + 1].phone = pronunciation[i];
  }
  if (!same) {
    throw Error{fmt::format(
        "Festival was asked to say '{}' and said '{}'", spell(pronunciation), symbols_of(speech))};
  }
}

}  // namespace

SpokenItem spoken_item(const FestivalSpeech& speech, std::span<const Phone> pronunciation) {
  SpokenItem item;
  item.sound.rate = Hertz{static_cast<double>(speech.rate_hz)};
  item.sound.samples.reserve(speech.samples.size());
  for (const std::int16_t sample : speech.samples) {
    item.sound.samples.push_back(static_cast<float>(sample) / kFullScale);
  }

  item.utterance = labelled(speech);
  auto& phones = item.utterance.phones;
  const Duration end = item.sound.duration();
  if (phones.size() < 3 || !is_rest(phones.front()) || !is_rest(phones.back()) ||
      phones.back().start >= end) {
    throw Error{
        fmt::format("Festival's segments '{}' do not have speech between two pauses within"
                    " its sound",
                    symbols_of(speech))};
  }
  phones.back().duration = end - phones.back().start;
  if (!pronunciation.empty()) rename(item.utterance, speech, pronunciation);
  return item;
}

}  // namespace bimodal::synth

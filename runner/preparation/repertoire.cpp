#include "runner/preparation/repertoire.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "protocols/model/talker.hpp"
#include "stimuli/audio/noise.hpp"
#include "stimuli/audio/release.hpp"
#include "stimuli/audio/resample.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/timeline/ambiguous_word.hpp"

namespace bimodal::runner {

namespace {

constexpr std::string_view kFestival = "festival:";

/// The very length: the sound of a stretch is rounded to samples, and an utterance ends with it.
void end_with(Utterance& utterance, Duration end) {
  if (utterance.phones.empty()) return;
  auto& last = utterance.phones.back();
  if (last.phone == Phone::Rest && end > last.start) last.duration = end - last.start;
}

/// Silent outside of the stretch, with falls of 5 ms at its edges: words cut out of running speech
/// have their neighbours in their margins.
void keep_only(Clip& sound, const SpeechInterval& clear) {
  constexpr Duration kFall = std::chrono::milliseconds{5};
  const auto sample = [&](Duration time) {
    const auto nearest = std::max<std::int64_t>(0, nearest_sample(time, sound.rate).count());
    return std::min(static_cast<std::size_t>(nearest), sound.samples.size());
  };
  const auto from = sample(clear.start);
  const auto to = sample(clear.end);
  const auto begin = sound.samples.begin();
  std::fill(begin, begin + static_cast<std::ptrdiff_t>(from), 0.0F);
  std::fill(begin + static_cast<std::ptrdiff_t>(to), sound.samples.end(), 0.0F);
  if (from < to) apply_ramps(std::span{sound.samples}.subspan(from, to - from), sample(kFall));
}

}  // namespace

Performance Repertoire::speak(const std::string& talker,
                              const std::string& spelling,
                              const Pronunciation& phones) {
  auto voice = voices_.find(talker);
  if (voice == voices_.end()) {
    voice = voices_.emplace(talker, synth::Voice{talker.substr(kFestival.size())}).first;
  }
  auto spoken = voice->second.speak(spelling, phones);
  return {.sound = resample(spoken.sound, rate_),
          .utterance = std::move(spoken.utterance),
          .source = std::nullopt,
          .release = std::nullopt};
}

Performance Repertoire::lie_between(const std::string& talker, const SeenWord& word) {
  const auto& segments = word.articulation;
  const auto& from = perform(talker, word.spelling, first_end(segments));
  const auto& to = perform(talker, word.spelling, last_end(segments));
  const auto release_ns = [](const Performance& performance) {
    return static_cast<double>(release_of(performance.sound, performance.utterance).count());
  };
  const auto release = std::lerp(release_ns(from), release_ns(to), mean_share(segments));
  return {.sound = {.rate = rate_, .samples = {}},
          .utterance = between(from.utterance, to.utterance, segments),
          .source = std::nullopt,
          .release = Duration{std::llround(release)}};
}

Performance Repertoire::play(const std::string& name, const std::string& spelling) {
  const auto corpus = corpora_.find(name);
  if (corpus == corpora_.end()) throw Error{fmt::format("there is no corpus '{}'", name)};
  const auto* const item = find_item(corpus->second, spelling);
  if (item == nullptr) {
    throw Error{
        fmt::format("the corpus '{}' has no item without doubt for \"{}\"", name, spelling)};
  }
  const auto& recording = corpus->second.recordings.at(item->recording);
  Performance performance{
      .sound = {.rate = rate_, .samples = {}},
      .utterance = utterance_of(*item),
      .source = RecordedSource{.corpus = name,
                               .item = item->name,
                               .file = recording.file,
                               .sha256 = recording.sha256,
                               .path = media_file(corpus->second, item->recording),
                               .span = {item->start, item->end}},
      .release = std::nullopt};
  const auto& source = *performance.source;
  if (tracks_.has_sound(source.path)) {
    performance.sound = tracks_.read(source.path, rate_, source.span);
    if (item->clear) {
      keep_only(performance.sound,
                {item->clear->start - item->start, item->clear->end - item->start});
    }
    end_with(performance.utterance, performance.sound.duration());
  }
  return performance;
}

const Performance& Repertoire::perform(const std::string& talker,
                                       const std::string& spelling,
                                       const Pronunciation& phones) {
  const std::lock_guard lock{mutex_};
  auto& kept = performances_[talker + ' ' + spelling + ' ' + spell(phones)];
  if (kept) return *kept;
  if (talker.starts_with(kFestival)) {
    kept = std::make_unique<Performance>(speak(talker, spelling, phones));
  } else if (protocols::is_corpus(talker)) {
    kept = std::make_unique<Performance>(play(protocols::corpus_name(talker), spelling));
  } else {
    throw Error{fmt::format(
        "the talker '{}' is not known; use 'festival:kal', 'festival:slt' or 'corpus:NAME'",
        talker)};
  }
  return *kept;
}

const Performance& Repertoire::perform(const std::string& talker, const SeenWord& word) {
  if (word.articulation.empty() || protocols::is_corpus(talker)) {
    return perform(talker, word.spelling, word.phones);
  }
  auto made = lie_between(talker, word);
  const std::lock_guard lock{mutex_};
  auto& kept = performances_[talker + ' ' + word.spelling + ' ' + spell(word.articulation)];
  if (!kept) kept = std::make_unique<Performance>(std::move(made));
  return *kept;
}

}  // namespace bimodal::runner

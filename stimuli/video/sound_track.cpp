#include "stimuli/video/sound_track.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include <fmt/format.h>

#include "stimuli/audio/resample.hpp"
#include "stimuli/video/channel_mean.hpp"
#include "stimuli/video/container.hpp"
#include "stimuli/video/survey.hpp"
#include "stimuli/video/track_decoder.hpp"

namespace bimodal {

namespace {

constexpr auto kDeed = "read the sound of";
constexpr Duration kLongestStretch = std::chrono::hours{1};
constexpr double kLowestRate = 4'000;
constexpr double kHighestRate = 384'000;
/// Time stamps in whole milliseconds, and those of MPEG, waver by less; a lost packet is longer.
constexpr Duration kJitter = std::chrono::milliseconds{10};

std::int64_t sample_at(Duration time, Hertz rate) {
  return nearest_sample(time, rate).count();
}

void require_hearable(const libav::Survey& survey, const std::filesystem::path& file) {
  if (!survey.media.sound) {
    libav::refuse(kDeed, file, "it has no sound that can be decoded", "name one with sound");
  }
  const double rate = survey.media.sound->rate.count();
  if (rate >= kLowestRate && rate <= kHighestRate) return;
  libav::refuse(kDeed,
                file,
                fmt::format("it has {} samples per second", rate),
                fmt::format("resample it to between {} and {}", kLowestRate, kHighestRate));
}

/// The samples first ... last - 1 of a track whose samples arrive in frames with their places.
class Stretch {
 public:
  Stretch(std::int64_t first, std::int64_t last) : first_{first}, last_{last} {}

  [[nodiscard]] bool complete() const { return place_ >= last_; }

  /// Where the next sample stands.
  [[nodiscard]] std::int64_t place() const { return place_; }

  /// Silence up to `place`.
  void wait_until(std::int64_t place) {
    const auto from = std::clamp(place_, first_, last_);
    const auto to = std::clamp(place, from, last_);
    kept_.resize(kept_.size() + static_cast<std::size_t>(to - from), 0.0F);
    place_ = std::max(place_, place);
  }

  void append(std::span<const float> samples) {
    const auto count = static_cast<std::int64_t>(samples.size());
    const auto from = std::clamp<std::int64_t>(first_ - place_, 0, count);
    const auto to = std::clamp<std::int64_t>(last_ - place_, from, count);
    kept_.insert(kept_.end(), samples.begin() + from, samples.begin() + to);
    place_ += count;
  }

  [[nodiscard]] std::vector<float>& samples() { return kept_; }

 private:
  std::int64_t first_;
  std::int64_t last_;
  std::int64_t place_ = 0;
  std::vector<float> kept_;
};

/// Decodes until the stretch is complete or the track ends.
void fill(Stretch& stretch, const std::filesystem::path& file, const libav::Survey& survey) {
  libav::Container container{file};
  const auto& track = *container.sound();
  container.read_only(track);
  libav::TrackReader reader{container, track, 1};
  const auto& sound = *survey.media.sound;
  const auto jitter = sample_at(kJitter, sound.rate);
  const auto frame = libav::new_frame();
  std::vector<float> block;
  bool begun = false;
  while (!stretch.complete() && reader.next(*frame)) {
    const auto time = libav::duration_of(frame->best_effort_timestamp, track.time_base);
    const auto expected = stretch.place();
    const auto place = time ? sample_at(*time - survey.zero, sound.rate) : expected;
    if (frame->sample_rate != static_cast<int>(sound.rate.count()) ||
        frame->ch_layout.nb_channels != sound.channels) {
      libav::refuse(
          kDeed,
          file,
          fmt::format("after {} samples its rate or number of channels changes", expected),
          "cut it there or convert it, e.g. by 'ffmpeg -i IN OUT'");
    }
    block.clear();
    if (!libav::append_channel_mean(*frame, block)) {
      libav::refuse(kDeed, file, "FFmpeg decodes it to an unknown format", "convert it to WAV");
    }
    const auto bad = std::ranges::find_if_not(block, [](float it) { return std::isfinite(it); });
    if (bad != block.end()) {
      libav::refuse(
          kDeed,
          file,
          fmt::format("sample {} is not a finite number", expected + (bad - block.begin())),
          "make the sound again");
    }
    std::int64_t overlap = 0;
    if (!begun || place > expected + jitter) {
      stretch.wait_until(place);
    } else if (place < expected - jitter) {
      overlap = std::min(expected - place, static_cast<std::int64_t>(block.size()));
    }
    begun = true;
    stretch.append(std::span{block}.subspan(static_cast<std::size_t>(overlap)));
  }
}

}  // namespace

Clip read_sound_track(const std::filesystem::path& file, Hertz rate, MediaSpan span) {
  const auto survey = libav::survey_of(file);
  require_hearable(survey, file);
  const auto own_rate = survey.media.sound->rate;
  const auto end = libav::end_within(survey, file, span.start, span.end);
  if (std::min(end, survey.media.length) - span.start > kLongestStretch) {
    libav::refuse(kDeed, file, "the stretch is longer than an hour", "take shorter ones");
  }
  const bool to_the_end = span.end == Duration::max();
  const auto first = sample_at(span.start, own_rate);
  Stretch stretch{first, sample_at(to_the_end ? span.start + kLongestStretch : end, own_rate)};
  fill(stretch, file, survey);
  if (!to_the_end) stretch.wait_until(sample_at(end, own_rate));
  if (stretch.samples().empty()) {
    libav::refuse(kDeed,
                  file,
                  "it ends before " + libav::in_seconds(span.start),
                  "choose a stretch in which there is something to be heard");
  }
  Clip sound{own_rate, std::move(stretch.samples())};
  return rate == Hertz{0} ? sound : resample(sound, rate);
}

}  // namespace bimodal

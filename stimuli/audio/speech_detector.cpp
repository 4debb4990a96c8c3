#include "stimuli/audio/speech_detector.hpp"

#include <algorithm>
#include <cmath>

namespace bimodal {

namespace {

constexpr Duration kFrame = std::chrono::milliseconds{10};
constexpr std::size_t kFramesPerSecond = 100;
constexpr double kOpens = 15.0;
constexpr double kStays = 8.0;
constexpr double kQuietestRoom = -75.0;
constexpr double kLowest = -120.0;
constexpr std::size_t kShortestSpeech = 5;   ///< frames
constexpr std::size_t kShortestRelease = 2;  ///< frames

/// The sample with which frame `index` begins.
std::size_t frame_start(std::size_t index, double rate) {
  return static_cast<std::size_t>(
      std::llround(rate * static_cast<double>(index) / static_cast<double>(kFramesPerSecond)));
}

double level_of_power(double power) {
  return std::max(kLowest, 10.0 * std::log10(power + 1e-30));
}

Duration frames(std::size_t count) {
  return kFrame * static_cast<std::int64_t>(count);
}

}  // namespace

double RumbleFilter::operator()(float sample) {
  const auto in = static_cast<double>(sample);
  if (!primed_) filter_.settle(in);
  primed_ = true;
  return filter_(in);
}

Decibels room_level(const Clip& room) {
  RumbleFilter filter{room.rate};
  std::vector<double> powers;
  std::size_t at = 0;
  for (std::size_t index = 1;; ++index) {
    const auto end = frame_start(index, room.rate.count());
    if (end > room.samples.size()) break;
    const auto count = static_cast<double>(end - at);
    double sum = 0.0;
    for (; at < end; ++at) {
      const double out = filter(room.samples[at]);
      sum += out * out;
    }
    powers.push_back(sum / count);
  }
  if (powers.empty()) return Decibels{kLowest};
  const auto middle = powers.begin() + static_cast<std::ptrdiff_t>(powers.size() / 2);
  std::ranges::nth_element(powers, middle);
  return Decibels{level_of_power(*middle)};
}

SpeechDetector::SpeechDetector(Hertz rate, Decibels room)
    : filter_{rate},
      rate_{rate.count()},
      opens_{std::max(room.count(), kQuietestRoom) + kOpens},
      stays_{std::max(room.count(), kQuietestRoom) + kStays},
      frame_end_{frame_start(1, rate_)} {}

void SpeechDetector::feed(std::span<const float> samples) {
  for (const float sample : samples) {
    const double out = filter_(sample);
    sum_ += out * out;
    if (++samples_ < frame_end_) continue;
    take_frame(level_of_power(sum_ / static_cast<double>(samples_ - frame_begin_)));
    sum_ = 0.0;
    frame_begin_ = samples_;
    frame_end_ = frame_start(frames_ + 1, rate_);
  }
}

void SpeechDetector::take_frame(double level) {
  const auto frame = frames_++;
  if (level < stays_) {
    run_.reset();
    opened_ = false;
    return;
  }
  if (!run_) run_ = frame;
  opened_ = opened_ || level >= opens_;
  const auto length = frame + 1 - *run_;
  if (!opened_ || length < (speech_ ? kShortestRelease : kShortestSpeech)) return;
  if (!speech_) speech_ = SpeechInterval{frames(*run_), {}};
  speech_->end = frames(frame + 1);
}

Duration SpeechDetector::heard() const {
  return frames(frames_);
}

std::optional<Duration> SpeechDetector::silence() const {
  if (!speech_) return std::nullopt;
  return heard() - speech_->end;
}

}  // namespace bimodal

#include "runner/cli/simulated_talker.hpp"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "stimuli/audio/resample.hpp"
#include "stimuli/audio/sound_file.hpp"
#include "stimuli/audio/speech_detector.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

using namespace std::chrono_literals;

constexpr Duration kBefore = 100ms;
constexpr Duration kAfter = 150ms;
constexpr Duration kLongestPause = 300ms;
constexpr Duration kWindow = 200ms;
constexpr double kQuietPart = 0.1;  ///< of all windows: so many hold the room alone

/// Samples from first up to, not including, end.
struct Stretch {
  std::size_t first = 0;
  std::size_t end = 0;
};

std::size_t samples_of(Duration time, Hertz rate) {
  return static_cast<std::size_t>(nearest_sample(time, rate).count());
}

Decibels quiet_level(const Clip& sound) {
  const auto length = samples_of(kWindow, sound.rate);
  std::vector<Decibels> levels;
  for (std::size_t at = 0; at + length <= sound.samples.size(); at += length) {
    const auto window = std::span{sound.samples}.subspan(at, length);
    const bool is_a_room = std::ranges::any_of(window, [](float sample) { return sample != 0.0F; });
    if (!is_a_room) continue;  // zeros are put there by programs
    levels.push_back(room_level({sound.rate, {window.begin(), window.end()}}));
  }
  if (levels.empty()) return room_level(sound);
  const auto quiet = levels.begin() + static_cast<std::ptrdiff_t>(
                                          kQuietPart * static_cast<double>(levels.size() - 1));
  std::ranges::nth_element(levels, quiet);
  return *quiet;
}

std::vector<Stretch> speech_in(const Clip& sound) {
  const auto room = quiet_level(sound);
  const auto step = samples_of(10ms, sound.rate);
  const auto before = samples_of(kBefore, sound.rate);
  const auto after = samples_of(kAfter, sound.rate);
  std::vector<Stretch> found;
  std::size_t base = 0;
  SpeechDetector detector{sound.rate, room};
  for (std::size_t at = 0; at < sound.samples.size(); at += step) {
    const auto block =
        std::span{sound.samples}.subspan(at, std::min(step, sound.samples.size() - at));
    detector.feed(block);
    const bool is_last = at + step >= sound.samples.size();
    if (!detector.speech() || (!is_last && *detector.silence() < kLongestPause)) continue;
    const auto first = base + samples_of(detector.speech()->start, sound.rate);
    const auto end = base + samples_of(detector.speech()->end, sound.rate) + after;
    found.push_back({first > before ? first - before : 0, std::min(end, sound.samples.size())});
    base = at + block.size();
    detector = SpeechDetector{sound.rate, room};
  }
  return found;
}

std::vector<float> longest_between(const std::vector<Stretch>& speech, const Clip& sound) {
  Stretch longest;
  std::size_t from = 0;
  const auto consider = [&](std::size_t to) {
    if (to > from && to - from > longest.end - longest.first) longest = {from, to};
  };
  for (const auto& stretch : speech) {
    consider(stretch.first);
    from = stretch.end;
  }
  consider(sound.samples.size());
  const auto part = std::span{sound.samples}.subspan(longest.first, longest.end - longest.first);
  return {part.begin(), part.end()};
}

}  // namespace

SimulatedInput::Options talker_of(const std::filesystem::path& recording, Hertz rate) {
  const auto sound = resample(read_sound(recording, Channels::MixDown), rate);
  const auto speech = speech_in(sound);
  if (speech.empty()) {
    throw Error{fmt::format(
        "cannot take '{}' for a talker: nobody speaks in it; give a recording of words with "
        "pauses between them",
        recording.string())};
  }
  SimulatedInput::Options talker{.rate = rate, .room = longest_between(speech, sound)};
  for (const auto& stretch : speech) {
    const auto part = std::span{sound.samples}.subspan(stretch.first, stretch.end - stretch.first);
    talker.utterances.emplace_back(part.begin(), part.end());
  }
  return talker;
}

}  // namespace bimodal::runner

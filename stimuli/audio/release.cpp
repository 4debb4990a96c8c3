#include "stimuli/audio/release.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

using namespace std::chrono_literals;

constexpr std::array kPlosives{
    Phone::P, Phone::B, Phone::T, Phone::D, Phone::K, Phone::G, Phone::CH, Phone::JH};
constexpr Duration kStep = 1ms;
constexpr Duration kWindow = 5ms;
constexpr Duration kBehind = 20ms;  ///< after the phone's end
constexpr double kLeastRiseDb = 6.0;
constexpr double kCornerHz = 1000.0;
constexpr double kFloor = 1e-10;  ///< -100 dB FS: digital silence has no logarithm

/// Power above 1 kHz (one-pole high-pass, 6 dB an octave, twice) in steps of a millisecond.
std::vector<double> high_power(const Clip& sound) {
  const double pole = std::exp(-2.0 * std::numbers::pi * kCornerHz / sound.rate.count());
  std::array<double, 2> low{};
  const auto step = static_cast<std::size_t>(
      std::max(1.0, std::round(sound.rate.count() * std::chrono::duration<double>{kStep}.count())));
  std::vector<double> power(sound.samples.size() / step + 1, 0.0);
  for (std::size_t i = 0; i < sound.samples.size(); ++i) {
    double sample = static_cast<double>(sound.samples[i]);
    for (auto& state : low) {
      state = pole * state + (1.0 - pole) * sample;
      sample -= state;
    }
    power[i / step] += sample * sample / static_cast<double>(step);
  }
  return power;
}

double mean_db(const std::vector<double>& power, std::size_t from, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = from; i < from + count; ++i) sum += power[i];
  return 10.0 * std::log10(sum / static_cast<double>(count) + kFloor);
}

/// Where the power rises most from one window to the next, between two instants.
std::optional<Duration> burst(const Clip& sound, Duration from, Duration to) {
  const auto power = high_power(sound);
  constexpr auto kSteps = static_cast<std::size_t>(kWindow / kStep);
  const auto first = std::max(static_cast<std::size_t>(from / kStep), kSteps);
  const auto last = static_cast<std::size_t>(to / kStep);
  double steepest = kLeastRiseDb;
  std::optional<Duration> found;
  for (std::size_t i = first; i <= last && i + kSteps <= power.size(); ++i) {
    const double rise = mean_db(power, i, kSteps) - mean_db(power, i - kSteps, kSteps);
    if (rise <= steepest) continue;
    steepest = rise;
    found = static_cast<std::int64_t>(i) * kStep;
  }
  return found;
}

}  // namespace

Duration release_of(const Clip& sound, const Utterance& utterance) {
  const auto& phones = utterance.phones;
  const auto spoken = [](const TimedPhone& timed) { return timed.phone != Phone::Rest; };
  const auto first = std::ranges::find_if(phones, spoken);
  if (first == phones.end()) throw Error{"nothing is released where nothing is said"};
  const auto vowel =
      std::ranges::find_if(phones, [](const TimedPhone& timed) { return is_vowel(timed.phone); });
  if (vowel == phones.end()) return first->start;
  if (vowel == first) return vowel->start;
  const auto& consonant = *(vowel - 1);
  if (std::ranges::find(kPlosives, consonant.phone) == kPlosives.end()) return vowel->start;
  return burst(sound, consonant.start, consonant.end() + kBehind).value_or(vowel->start);
}

}  // namespace bimodal

#include "stimuli/alignment/search_sound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include <fmt/format.h>

#include "stimuli/alignment/cepstra.hpp"
#include "stimuli/audio/resample.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal {

namespace {

constexpr Duration kPadding = std::chrono::milliseconds{200};
constexpr std::size_t kPaddingSamples = 3200;
constexpr std::size_t kFrameSamples = 160;
constexpr double kSilence = 1e-4;
constexpr double kPeak = 0.9;
constexpr double kFullScale = std::numeric_limits<std::int16_t>::max();
constexpr double kQuietPart = 0.02;
constexpr double kHighestFloor = 0.01;  ///< re the peak
constexpr double kRoom = 1e-3;          ///< re the peak: 60 dB below it
constexpr Seed kNoiseSeed = 1976;

void refuse_what_is_no_number(const Clip& sound) {
  const auto wrong =
      std::ranges::find_if(sound.samples, [](float sample) { return !std::isfinite(sample); });
  if (wrong == sound.samples.end()) return;
  throw Error{fmt::format("aligning a recording: sample {} is not a finite number; repair it",
                          wrong - sound.samples.begin())};
}

/// The same sound around 0.
std::vector<double> centred(const Clip& sound) {
  std::vector<double> samples(sound.samples.begin(), sound.samples.end());
  const double mean = std::accumulate(samples.begin(), samples.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(samples.size(), 1));
  for (double& sample : samples) sample -= mean;
  return samples;
}

double root_mean_square(std::span<const double> samples) {
  double sum = 0.0;
  for (const double sample : samples) sum += sample * sample;
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

double floor_of(std::span<const double> samples) {
  std::vector<double> levels;
  for (std::size_t at = 0; at + kFrameSamples <= samples.size(); at += kFrameSamples) {
    levels.push_back(root_mean_square(samples.subspan(at, kFrameSamples)));
  }
  if (levels.empty()) return 0.0;
  const auto quiet = static_cast<std::ptrdiff_t>(static_cast<double>(levels.size()) * kQuietPart);
  std::ranges::nth_element(levels, levels.begin() + quiet);
  return *(levels.begin() + quiet);
}

}  // namespace

SearchSound search_sound(const Clip& sound) {
  refuse_what_is_no_number(sound);
  auto heard = centred(resample(sound, CepstraMaker::kRate));
  double peak = 0.0;
  for (const double sample : heard) peak = std::max(peak, std::abs(sample));
  if (peak < kSilence) {
    throw Error{fmt::format("aligning a recording of {} samples: {}; give a recording of speech",
                            sound.samples.size(),
                            sound.samples.empty()
                                ? "there is nothing in it"
                                : "it is silent (nothing above -80 dB re full scale)")};
  }
  const double gain = kPeak * kFullScale / peak;
  const double floor = gain * std::min(floor_of(heard), kHighestFloor * peak);
  SearchSound made{.samples = {}, .padding = kPadding};
  made.samples.reserve(heard.size() + 2 * kPaddingSamples);
  const double room = kRoom * kPeak * kFullScale;
  Random random{kNoiseSeed};
  const auto add = [&](double sample) {
    made.samples.push_back(static_cast<std::int16_t>(
        std::clamp(std::round(sample + room * random.normal()), -kFullScale, kFullScale)));
  };
  for (std::size_t i = 0; i < kPaddingSamples; ++i) add(floor * random.normal());
  for (const double sample : heard) add(gain * sample);
  for (std::size_t i = 0; i < kPaddingSamples; ++i) add(floor * random.normal());
  return made;
}

}  // namespace bimodal

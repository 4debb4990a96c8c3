#include "stimuli/audio/time_scale.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include <fmt/format.h>
#include <rubberband/RubberBandStretcher.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/milliseconds.hpp"

namespace bimodal {

namespace {

using Stretcher = RubberBand::RubberBandStretcher;

/// The longest window of the engine reaches so far beyond the sound.
constexpr Duration kPadding = std::chrono::milliseconds{250};
/// What is handed over at once; of larger blocks the engine drops what does not fit its buffers.
constexpr std::size_t kBlock = 1024;
/// The engine is made for these rates; the rate only chooses its windows.
constexpr double kLowestRate = 8'000;
constexpr double kHighestRate = 192'000;

void require_possible(double rate) {
  if (rate >= kSlowest && rate <= kFastest) return;
  throw Error{fmt::format(
      "cannot make speech {} times as fast; give a rate from {} to {}", rate, kSlowest, kFastest)};
}

/// Calls `use` with each block and whether it is the last.
template <typename Use>
void by_blocks(std::span<const float> samples, Use use) {
  for (std::size_t done = 0; done < samples.size();) {
    const auto block = samples.subspan(done, std::min(kBlock, samples.size() - done));
    done += block.size();
    use(block, done == samples.size());
  }
}

void retrieve(Stretcher& stretcher, std::vector<float>& made) {
  for (int ready = stretcher.available(); ready > 0; ready = stretcher.available()) {
    const auto before = made.size();
    made.resize(before + static_cast<std::size_t>(ready));
    float* place = made.data() + before;
    made.resize(before + stretcher.retrieve(&place, static_cast<std::size_t>(ready)));
  }
}

std::vector<float> stretched(std::span<const float> samples, Hertz at, double rate) {
  Stretcher stretcher{
      static_cast<std::size_t>(std::round(std::clamp(at.count(), kLowestRate, kHighestRate))),
      1,
      Stretcher::OptionProcessOffline | Stretcher::OptionEngineFiner |
          Stretcher::OptionThreadingNever,
      1.0 / rate};
  stretcher.setExpectedInputDuration(samples.size());
  stretcher.setMaxProcessSize(kBlock);
  by_blocks(samples, [&](std::span<const float> block, bool last) {
    const float* const channel = block.data();
    stretcher.study(&channel, block.size(), last);
  });
  std::vector<float> made;
  by_blocks(samples, [&](std::span<const float> block, bool last) {
    const float* const channel = block.data();
    stretcher.process(&channel, block.size(), last);
    retrieve(stretcher, made);
  });
  return made;
}

Duration scaled(Duration time, double rate) {
  return Duration{std::llround(static_cast<double>(time.count()) / rate)};
}

}  // namespace

Clip change_rate(const Clip& sound, double rate) {
  require_possible(rate);
  if (rate == 1.0 || sound.samples.empty()) return sound;
  const auto padding = static_cast<std::size_t>(nearest_sample(kPadding, sound.rate).count());
  std::vector<float> padded(sound.samples.size() + 2 * padding, 0.0F);
  std::ranges::copy(sound.samples, padded.begin() + static_cast<std::ptrdiff_t>(padding));

  auto made = stretched(padded, sound.rate, rate);
  const auto before = static_cast<std::size_t>(std::round(static_cast<double>(padding) / rate));
  const auto length =
      static_cast<std::size_t>(std::floor(static_cast<double>(sound.samples.size()) / rate + 0.5));
  // The engine's own length is a few samples off; what is missing is padding anyway.
  made.resize(std::max(made.size(), before + length), 0.0F);
  made.erase(made.begin(), made.begin() + static_cast<std::ptrdiff_t>(before));
  made.resize(length);
  return {sound.rate, std::move(made)};
}

Utterance change_rate(const Utterance& utterance, double rate) {
  require_possible(rate);
  Utterance made = utterance;
  for (auto& timed : made.phones) {
    const auto end = scaled(timed.end(), rate);
    timed.start = scaled(timed.start, rate);
    timed.duration = end - timed.start;
  }
  return made;
}

Clip reversed(Clip sound) {
  std::ranges::reverse(sound.samples);
  return sound;
}

Utterance reversed(const Utterance& utterance) {
  Utterance made = utterance;
  std::ranges::reverse(made.phones);
  for (auto& timed : made.phones) timed.start = utterance.end() - timed.end();
  return made;
}

Clip gated(Clip sound, Duration instant, Duration ramp) {
  if (instant < Duration{} || ramp < Duration{}) {
    throw Error{fmt::format("cannot gate sound at {} ms with a fall of {} ms; give 0 or more",
                            milliseconds(instant),
                            milliseconds(ramp))};
  }
  const auto silence = nearest_sample(instant, sound.rate).count();
  const auto fall = nearest_sample(ramp, sound.rate).count();
  const auto size = static_cast<std::int64_t>(sound.samples.size());
  for (auto i = std::clamp<std::int64_t>(silence - fall, 0, size); i < size; ++i) {
    auto& sample = sound.samples[static_cast<std::size_t>(i)];
    const double left =
        static_cast<double>(silence - i) / static_cast<double>(std::max<std::int64_t>(fall, 1));
    const double gain = left > 0.0 ? 0.5 * (1.0 - std::cos(std::numbers::pi * left)) : 0.0;
    sample = static_cast<float>(static_cast<double>(sample) * gain);
  }
  return sound;
}

}  // namespace bimodal

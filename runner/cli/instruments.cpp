#include "runner/cli/instruments.hpp"

#include <algorithm>
#include <cmath>

#include "runner/devices/device_error.hpp"
#include "runner/timing/instrument_onsets.hpp"

namespace bimodal::runner {

namespace {

using namespace std::chrono_literals;

constexpr Duration kBefore = 120ms;  ///< of a reported onset, searched
constexpr Duration kRest = 40ms;     ///< of it, in which nothing happens yet
constexpr Duration kAfter = 120ms;
constexpr Duration kLasting = 2ms;  ///< light that is gone sooner is a flicker

std::size_t frames(Duration duration, Hertz rate) {
  return static_cast<std::size_t>(nearest_sample(duration, rate).count());
}

}  // namespace

Instruments::Instruments(AudioInput& input, const Options& options)
    : input_{input}, options_{options} {
  input_.start();
  first_ = input_.first_frame();
}

void Instruments::collect() {
  input_.collect(samples_);
}

std::int64_t Instruments::captured() const {
  return first_ + static_cast<std::int64_t>(samples_.size() / input_.channels());
}

std::vector<float> Instruments::channel(std::size_t which,
                                        std::int64_t from,
                                        std::size_t count) const {
  std::vector<float> signal(count);
  const auto channels = input_.channels();
  const auto offset = static_cast<std::size_t>(from - first_);
  for (std::size_t i = 0; i < count; ++i) signal[i] = samples_[(offset + i) * channels + which];
  return signal;
}

Instant Instruments::instant_of(double frame) {
  const auto fit = input_.clock()->fit;
  const auto whole = std::floor(frame);
  const auto rest = (frame - whole) * fit.nanoseconds_per_sample;
  return fit.instant_of(static_cast<std::int64_t>(whole)) + Duration{std::llround(rest)} -
         options_.delay;
}

void Instruments::find(TimedTrial& trial, const std::function<void()>& rest) {
  collect();
  if (!trial.visual || !trial.auditory || !input_.clock()) return;
  const auto rate = input_.rate();
  std::int64_t first_searched = captured();
  const auto search = [&](Duration reported, std::size_t which, auto onset_in) {
    const Instant from = Instant{reported} + options_.delay - kBefore;
    const auto begin = std::max(input_.clock()->fit.sample_at(from), first_);
    first_searched = std::min(first_searched, begin);
    const auto count = frames(kBefore + kAfter, rate);
    while (captured() < begin + static_cast<std::int64_t>(count)) {
      rest();
      collect();
    }
    const auto found = onset_in(channel(which, begin, count));
    if (!found) return std::optional<Duration>{};
    return std::optional{instant_of(static_cast<double>(begin) + *found).time_since_epoch()};
  };
  trial.true_visual =
      search(*trial.visual, options_.photodiode, [&](const std::vector<float>& signal) {
        return onset_of_light(signal, frames(kRest, rate), frames(kLasting, rate));
      });
  trial.true_auditory =
      search(*trial.auditory, options_.loopback, [&](const std::vector<float>& signal) {
        return onset_of_sound(signal, frames(kRest, rate));
      });
  if (input_.clock()->latest_jump > first_searched) {
    trial.true_visual.reset();
    trial.true_auditory.reset();
  }
  // What lies before is not needed any more.
  const auto keep = input_.clock()->fit.sample_at(Instant{*trial.visual} + options_.delay);
  const auto gone = std::clamp<std::int64_t>(keep - first_, 0, captured() - first_);
  samples_.erase(samples_.begin(),
                 samples_.begin() + gone * static_cast<std::int64_t>(input_.channels()));
  first_ += gone;
}

}  // namespace bimodal::runner

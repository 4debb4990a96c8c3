#include "stimuli/audio/resample.hpp"

#include <cmath>

#include <fmt/format.h>
#include <soxr.h>

#include "stimuli/base/error.hpp"

namespace bimodal {

namespace {

constexpr double kLargestRatio = 1000.0;

}  // namespace

Clip resample(const Clip& sound, Hertz rate) {
  const double ratio = rate.count() / sound.rate.count();
  if (!(rate.count() > 0.0) || !(ratio <= kLargestRatio) || !(ratio >= 1.0 / kLargestRatio)) {
    throw Error{
        fmt::format("cannot resample sound from {} to {} samples per second; give rates "
                    "above 0 that differ by less than a factor of {}",
                    sound.rate.count(),
                    rate.count(),
                    kLargestRatio)};
  }
  if (rate == sound.rate || sound.samples.empty()) return {rate, sound.samples};

  const auto length =
      static_cast<std::size_t>(std::floor(static_cast<double>(sound.samples.size()) * ratio + 0.5));
  // libsoxr rounds the length in its own way: silence behind the sound, and room for it, lets it
  // reach the length that we promise.
  constexpr double kMargin = 2.0;
  auto padded = sound.samples;
  padded.resize(padded.size() + static_cast<std::size_t>(std::ceil(kMargin / ratio) + kMargin));

  Clip resampled{rate, {}};
  const double room = std::ceil(static_cast<double>(padded.size()) * ratio + kMargin);
  resampled.samples.resize(static_cast<std::size_t>(room));
  const auto io = soxr_io_spec(SOXR_FLOAT32_I, SOXR_FLOAT32_I);
  const auto quality = soxr_quality_spec(SOXR_VHQ, 0);
  const auto runtime = soxr_runtime_spec(1);
  std::size_t used = 0;
  std::size_t made = 0;
  const auto* const failure = soxr_oneshot(sound.rate.count(),
                                           rate.count(),
                                           1,
                                           padded.data(),
                                           padded.size(),
                                           &used,
                                           resampled.samples.data(),
                                           resampled.samples.size(),
                                           &made,
                                           &io,
                                           &quality,
                                           &runtime);
  if (failure != nullptr || made < length) {
    throw Error{
        fmt::format("cannot resample {} samples from {} to {} per second: libsoxr made {} "
                    "({}); choose another rate",
                    sound.samples.size(),
                    sound.rate.count(),
                    rate.count(),
                    made,
                    failure != nullptr ? failure : "no reason given")};
  }
  resampled.samples.resize(length);
  return resampled;
}

}  // namespace bimodal

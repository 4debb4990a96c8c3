#include "stimuli/audio/mix.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "stimuli/audio/noise.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/milliseconds.hpp"

namespace bimodal {

namespace {

constexpr Duration kEdgeFade = std::chrono::milliseconds{5};

std::size_t samples_in(Duration duration, Hertz rate, const char* name) {
  if (duration < Duration{}) {
    throw Error{fmt::format(
        "cannot mix with a negative {} ({} ms); give 0 or more", name, milliseconds(duration))};
  }
  return static_cast<std::size_t>(nearest_sample(duration, rate).count());
}

/// The level of the speech in its recording with faded edges.
Decibels level_of(const Clip& speech, const MixRequest& request, FourierTransform& fourier) {
  const auto found = band_level(cut(speech, request.interval), speech.rate, request.band, fourier);
  if (!std::isfinite(found.count())) {
    throw Error{fmt::format(
        "cannot bring the speech to {} dB: between {} and {} Hz its interval is {}; check the "
        "recording and its labels",
        request.speech_level.count(),
        request.band.low.count(),
        request.band.high.count(),
        found.count() < 0.0 ? "silent" : "not made of numbers")};
  }
  return found;
}

double largest_absolute(std::span<const float> samples) {
  const auto [lowest, highest] = std::ranges::minmax(samples);
  return static_cast<double>(std::max(-lowest, highest));
}

}  // namespace

std::optional<Mix> mix(const MixRequest& request, FourierTransform& fourier) {
  if (request.speech == nullptr) return std::nullopt;
  Clip speech = *request.speech;
  const auto rate = speech.rate;
  apply_ramps(speech.samples, samples_in(kEdgeFade, rate, "fade"));
  const auto found =
      request.recording_level ? *request.recording_level : level_of(speech, request, fourier);
  const auto gain = static_cast<float>(amplitude(request.speech_level - found));
  const auto lead = samples_in(request.lead, rate, "lead");
  const auto trail = samples_in(request.trail, rate, "trail");

  Mix made;
  made.sound.rate = rate;
  made.band = request.band;
  made.speech_dbfs = request.speech_level.count();
  made.recording_level = found;
  const auto length = lead + speech.samples.size() + trail;
  if (request.snr) {
    const auto noise_level = request.speech_level - *request.snr;
    made.noise_dbfs = noise_level.count();
    made.sound.samples = band_noise({.samples = length,
                                     .rate = rate,
                                     .band = request.band,
                                     .level = noise_level,
                                     .ramp = samples_in(request.ramp, rate, "ramp"),
                                     .seed = request.noise_seed},
                                    fourier);
  } else {
    made.sound.samples.assign(length, 0.0F);
  }
  made.speech_peak = static_cast<double>(gain) * largest_absolute(speech.samples);
  for (std::size_t i = 0; i < speech.samples.size(); ++i) {
    made.sound.samples[lead + i] += speech.samples[i] * gain;
  }
  made.peak = largest_absolute(made.sound.samples);
  const Duration shift{std::llround(1e9 * static_cast<double>(lead) / rate.count())};
  made.speech = {request.interval.start + shift, request.interval.end + shift};
  return made;
}

std::optional<Decibels> headroom_lacking(const Mix& mix) {
  if (mix.peak <= 1.0) return std::nullopt;
  return decibels(mix.peak);
}

double highest_peak(const Mix& mix) {
  constexpr double kDeviations = 6.0;
  if (!mix.noise_dbfs) return mix.speech_peak;
  return mix.speech_peak + kDeviations * amplitude(Decibels{*mix.noise_dbfs});
}

std::string sha256(const Clip& sound) {
  static_assert(std::endian::native == std::endian::little, "the hash is of little-endian floats");
  return sha256(std::as_bytes(std::span{sound.samples}));
}

}  // namespace bimodal

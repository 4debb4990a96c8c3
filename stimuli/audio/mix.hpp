#pragma once

#include <optional>
#include <string>

#include "stimuli/audio/band.hpp"
#include "stimuli/audio/clip.hpp"
#include "stimuli/audio/fourier.hpp"
#include "stimuli/base/quantity.hpp"
#include "stimuli/base/random.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

/// What is to be heard in one trial.
struct MixRequest {
  const Clip* speech = nullptr;  ///< at the session's rate; null: nothing is heard
  SpeechInterval interval;       ///< of the speech within its recording
  std::optional<Decibels> snr;   ///< absent: no noise
  Decibels speech_level{-26.0};  ///< over the interval, in the band, dB re full scale
  Band band;                     ///< in which both levels are measured; the noise is limited to it
  Duration lead = std::chrono::milliseconds{500};   ///< before the recording begins
  Duration trail = std::chrono::milliseconds{500};  ///< after it ends
  Duration ramp = std::chrono::milliseconds{50};    ///< of the noise, at both ends
  Seed noise_seed = 0;
  /// The recording's own level as an earlier Mix of the same recording, interval and band has it;
  /// absent: measured.
  std::optional<Decibels> recording_level;
};

/// The very samples of one trial, and what is true of them.
struct Mix {
  Clip sound;
  double speech_dbfs = 0.0;          ///< level in the band over the speech interval
  std::optional<double> noise_dbfs;  ///< level in the band between the ramps
  Decibels recording_level{0.0};     ///< of the speech before it was brought to its level
  Band band;
  double peak = 0.0;         ///< largest absolute sample; more than 1 would clip
  double speech_peak = 0.0;  ///< of the speech alone
  SpeechInterval speech;     ///< within the sound
};

/// The one mixer of the project; nothing else computes levels.
///
/// S/N is the level of the speech over its own interval minus the level of the noise between its
/// ramps, both within `band` (see band_level). The speech always has `speech_level`, the noise
/// speech_level - snr. The sound is `lead`, the recording, `trail`, each rounded to samples; noise
/// runs through all of it, from ramp to ramp. The recording's own edges are faded over 5 ms (raised
/// cosine), so that they do not click when there is no noise; the level is measured after that.
/// Nothing is clipped or limited: see headroom_lacking.
///
/// Returns nothing if there is no speech. Throws Error if the speech interval is empty, silent in
/// the band or outside the recording, or the band or the ramps are impossible.
[[nodiscard]] std::optional<Mix> mix(const MixRequest& request, FourierTransform& fourier);

/// By how many dB the sound is too loud to be played unclipped; absent if it is not. The remedy is
/// to lower the speech level by that much.
[[nodiscard]] std::optional<Decibels> headroom_lacking(const Mix& mix);

/// The peak that the same speech may reach with noise of any other seed: its own and six standard
/// deviations of the noise, which a sample of Gaussian noise exceeds once in 5 x 10^8.
[[nodiscard]] double highest_peak(const Mix& mix);

/// SHA-256 of the samples as 32-bit little-endian floats.
[[nodiscard]] std::string sha256(const Clip& sound);

}  // namespace bimodal

#pragma once

#include <span>

#include "stimuli/audio/clip.hpp"
#include "stimuli/audio/fourier.hpp"
#include "stimuli/base/quantity.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

/// A range of frequencies, both edges included.
struct Band {
  Hertz low{80};
  Hertz high{8000};

  bool operator==(const Band&) const = default;
};

/// Throws Error unless 0 <= low < high <= rate / 2.
void require_band(const Band& band, Hertz rate);

/// Level (RMS) of all samples, whatever their frequency; see band_level for the unit.
[[nodiscard]] Decibels level(std::span<const float> samples);

/// Level (RMS) of the part of `samples` that lies within `band`, in dB re full scale: 0 dB is an
/// RMS of 1, so that a sine that just does not clip has -3.01 dB (not the convention of AES17,
/// which is 3.01 dB higher). -infinity for silence and for no samples.
///
/// The samples are cut out rectangularly and followed by zeros up to N = fast_length(n); of their
/// discrete Fourier transform, the bins k with low <= k rate / N <= high are kept, with their
/// mirror images; by Parseval's theorem the mean square is the sum of |X[k]|^2 over all kept bins
/// divided by N n. A component near an edge is smeared over it by about rate / n.
[[nodiscard]] Decibels band_level(std::span<const float> samples,
                                  Hertz rate,
                                  const Band& band,
                                  FourierTransform& fourier);

/// The samples of `sound` from the nearest to interval.start up to, not including, the nearest to
/// interval.end. Throws Error if the interval is empty or not within the sound (more than a
/// sample).
[[nodiscard]] std::span<const float> cut(const Clip& sound, const SpeechInterval& interval);

/// The factor of amplitude that a difference of levels means: 10^(dB / 20).
[[nodiscard]] double amplitude(Decibels difference);

/// The inverse of amplitude(); -infinity for 0.
[[nodiscard]] Decibels decibels(double amplitude);

}  // namespace bimodal

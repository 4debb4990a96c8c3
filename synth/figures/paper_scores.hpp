#pragma once

#include <string>
#include <vector>

#include "synth/speech/score.hpp"

namespace bimodal::synth {

/// A segment of a figure, with the one control "p".
struct DrawnSegment {
  std::string symbol;
  double duration_ms;
  double target;
  Dominance dominance;
};

[[nodiscard]] Score score_of(const std::vector<DrawnSegment>& segments);

/// Figures 4 to 7: theta .035, c 1, two segments of 100 ms, targets .1 and .9.
struct TwoSegments {
  double alpha_of_first = 1;
  double theta_before_of_second = 0.035;
  double exponent = 1;
  DominanceForm form = DominanceForm::Exponential;
};

[[nodiscard]] Score two_segments(const TwoSegments& changed);

/// Figure 8, lip protrusion: alpha .06 for /s t/, 1 for /u/; `theta` for all, since the paper gives
/// only that before /u/. Durations (140, 60, 200 ms) and targets (.1, .1, .9) are chosen by us.
[[nodiscard]] Score stew(double theta);

/// The same for tongue angle: /t/ and /u/ have alpha 1, /s/ has .06; targets .1, .9, .1.
[[nodiscard]] Score stew_tongue(double theta);

/// Figures 9 and 10: one or two consonants of 100 ms together between vowels of 148 and 200 ms, so
/// that the second vowel's theta changes at 280 ms, 68 ms before its centre. Consonants have alpha
/// .06 and the second vowel theta .07 near its centre as in figure 8; theta .01 earlier and .02
/// elsewhere are chosen by us.
[[nodiscard]] Score vowels_around(std::size_t consonants, bool is_inflected);

inline constexpr double kThetaNear = 0.07;
inline constexpr double kThetaEarly = 0.01;
inline constexpr double kInflectionMs = 68;

/// Figure 11: protrusion in /utu/ (150, 100, 150 ms; targets .9, .1, .9; theta .02), at a speaking
/// rate. The alpha of /t/ makes the trough (.15, as in English) or the plateau (.01, as in
/// Turkish); all of this chosen by us.
[[nodiscard]] Score utu(double rate, double alpha_of_t = 0.15);

/// Figure 1: protrusion from /i/ (200 ms) over one or two consonants of 150 ms to /u/ (200 ms).
[[nodiscard]] Score towards_protrusion(std::size_t consonants);

}  // namespace bimodal::synth

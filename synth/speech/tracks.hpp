#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "stimuli/base/quantity.hpp"
#include "synth/speech/score.hpp"

namespace bimodal::synth {

/// Controls over time at an even rate.
struct Tracks {
  Hertz rate{};
  std::vector<std::string> controls;
  std::vector<double> time_ms;              ///< 0, 1000 / rate ... before the end
  std::vector<std::vector<double>> values;  ///< one row per control, as long as time_ms
  std::vector<std::string> symbols;         ///< of the segments
  std::vector<Claimant> segments;           ///< their times
  ControlClaims claims;                     ///< one row per control
  /// One table per control: for each of its claims, a row as long as time_ms. Empty if not asked.
  std::vector<std::vector<std::vector<double>>> dominance;
};

struct TrackOptions {
  Hertz rate{1000};
  Account account = Account::Dominance;
  std::vector<std::string> controls;  ///< empty: all
  bool with_dominance = false;
};

inline constexpr double kMostSamples = 50e6;  ///< of all controls and dominances together

/// Throws Error if a control is not one of the score's, or there would be more than kMostSamples.
[[nodiscard]] Tracks sample(const ScoreClaims& claims, const TrackOptions& options);

/// "time_ms,p,q,p@0,p@1": controls, then the dominance of each segment over each. Numbers read back
/// as they were.
[[nodiscard]] std::string csv_of(const Tracks& tracks);

/// The same with the segments and what they claim: its "segments" are those of a complete score
/// that moves in the same way.
[[nodiscard]] std::string json_of(const Tracks& tracks);

}  // namespace bimodal::synth

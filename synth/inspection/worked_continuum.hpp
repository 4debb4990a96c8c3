#pragma once

#include <optional>
#include <string>
#include <vector>

#include "synth/face/head.hpp"
#include "synth/speech/account.hpp"
#include "synth/speech/continuum.hpp"

namespace bimodal::synth {

/// The face of one token in the middle of the varied segment, and how its lips move about it.
struct TokenMiddle {
  Pose pose{};
  Pose released{};  ///< kReleased after the end of the segment
  LipMeasures lips;
  /// How long the lips are shut (a gap of at most kShutGapMm) without a break about the middle,
  /// also beyond the segment; 0 if they are not shut there.
  Milliseconds shut{};
  /// From the parting of the lips (from the middle, if they are open then) until they are half as
  /// far open as they come to be within kOpeningTime; absent if they are at once, or never open.
  std::optional<Milliseconds> half_open;
  double fastest_opening_mm_per_s = 0;  ///< of the inner height in that time
};

inline constexpr double kShutGapMm = 0.05;
inline constexpr Milliseconds kOpeningTime{300};
inline constexpr Milliseconds kReleased{30};

/// A continuum worked out: what tables, plots and pictures are made from.
struct Continuum {
  std::vector<ContinuumToken> tokens;
  std::vector<ScoreClaims> claims;   ///< one per token
  std::vector<TokenMiddle> middles;  ///< one per token
  Account account = Account::Dominance;
};

[[nodiscard]] Continuum worked_out(std::vector<ContinuumToken> tokens,
                                   const SegmentTable& table,
                                   Account account,
                                   const Head& head);

/// "token0" ... with as many digits as the last one needs.
[[nodiscard]] std::string token_name(const Continuum& continuum, std::size_t token);

/// What a user of the tokens should know: steps by which the lips open less than by the one before,
/// though on the whole they open more (or the other way round).
[[nodiscard]] std::vector<std::string> cautions(const Continuum& continuum);

}  // namespace bimodal::synth

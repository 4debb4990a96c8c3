#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "synth/speech/score.hpp"

namespace bimodal::synth {

/// What a step of a continuum changes in a segment: one number of what it asks of some controls.
enum class Varied : std::uint8_t { Target, Alpha, ThetaBefore, ThetaAfter, OffsetMs };

struct VariedParameter {
  Control control = Control::Jaw;
  Varied parameter = Varied::Target;
};

/// "cheek_puff", "lip_closure.theta_after" (target, alpha, theta_before, theta_after, offset_ms).
/// Throws Error, naming what is not known and what is.
[[nodiscard]] VariedParameter parse_varied(std::string_view text);

/// A row of tokens between two sounds, or along some parameters of one sound, in one context.
struct ContinuumDesign {
  Segment from;
  std::optional<Segment> to;            ///< absent: `varied` changes instead
  std::vector<VariedParameter> varied;  ///< in the varied segment, together
  double low = 0;                       ///< value of the varied parameters in the first token
  double high = 0;                      ///< in the last one
  std::size_t steps = 9;                ///< number of tokens, both ends included; 2 to kMostSteps
  std::string context = "_ AA";         ///< typed segments (typed_segments); "_" is the place
};

struct ContinuumToken {
  std::string name;  ///< "B~W:3/8", "B cheek_puff=0.5"
  double place = 0;  ///< 0 to 1
  Score score;
  std::size_t segment = 0;  ///< index of the varied segment in the score
};

/// The tokens in order. All have the durations of `from`, where the context states none, so that
/// only what is to vary does. Throws Error if the context has no "_" or several, the ends are the
/// same, a diphthong is varied, or a number is beyond use.
[[nodiscard]] std::vector<ContinuumToken> tokens_of(const ContinuumDesign& design,
                                                    const SegmentTable& table);

}  // namespace bimodal::synth

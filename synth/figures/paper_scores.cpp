#include "synth/figures/paper_scores.hpp"

namespace bimodal::synth {

Score score_of(const std::vector<DrawnSegment>& segments) {
  Score score;
  for (const auto& drawn : segments) {
    ScoreSegment segment{.symbol = drawn.symbol,
                         .segment = {},
                         .start = score.end(),
                         .duration = Milliseconds{drawn.duration_ms},
                         .controls = {}};
    const auto parsed = parse_segment(drawn.symbol);
    if (const auto* known = std::get_if<Segment>(&parsed)) segment.segment = *known;
    segment.controls["p"] = {.target = drawn.target, .dominance = drawn.dominance};
    score.segments.push_back(std::move(segment));
  }
  return score;
}

Score two_segments(const TwoSegments& changed) {
  constexpr double kTheta = 0.035;
  return score_of({{"1",
                    100,
                    0.1,
                    {.alpha = changed.alpha_of_first,
                     .theta_before = kTheta,
                     .theta_after = kTheta,
                     .exponent = changed.exponent,
                     .form = changed.form}},
                   {"2",
                    100,
                    0.9,
                    {.alpha = 1,
                     .theta_before = changed.theta_before_of_second,
                     .theta_after = kTheta,
                     .exponent = changed.exponent,
                     .form = changed.form}}});
}

Score stew(double theta) {
  const Dominance low{.alpha = 0.06, .theta_before = theta, .theta_after = theta};
  const Dominance high{.alpha = 1, .theta_before = theta, .theta_after = theta};
  return score_of({{"S", 140, 0.1, low}, {"T", 60, 0.1, low}, {"UW", 200, 0.9, high}});
}

Score stew_tongue(double theta) {
  const Dominance low{.alpha = 0.06, .theta_before = theta, .theta_after = theta};
  const Dominance high{.alpha = 1, .theta_before = theta, .theta_after = theta};
  return score_of({{"S", 140, 0.1, low}, {"T", 60, 0.9, high}, {"UW", 200, 0.1, high}});
}

Score vowels_around(std::size_t consonants, bool is_inflected) {
  constexpr double kTheta = 0.02;
  const Dominance first{.alpha = 1, .theta_before = kTheta, .theta_after = kTheta};
  const Dominance low{.alpha = 0.06, .theta_before = kTheta, .theta_after = kTheta};
  Dominance second{.alpha = 1, .theta_before = kThetaEarly, .theta_after = kTheta};
  if (is_inflected) {
    second.theta_before = kThetaNear;
    second.inflection_ms = kInflectionMs;
    second.theta_early = kThetaEarly;
  }
  std::vector<DrawnSegment> segments{{"IY", 148, 0.1, first}};
  for (std::size_t i = 0; i < consonants; ++i) {
    segments.push_back({"T", 100 / static_cast<double>(consonants), 0.1, low});
  }
  segments.push_back({"UW", 200, 0.9, second});
  return score_of(segments);
}

Score utu(double rate, double alpha_of_t) {
  constexpr double kTheta = 0.02;
  const Dominance vowel{.alpha = 1, .theta_before = kTheta, .theta_after = kTheta};
  const Dominance consonant{.alpha = alpha_of_t, .theta_before = kTheta, .theta_after = kTheta};
  return at_rate(
      score_of({{"UW", 150, 0.9, vowel}, {"T", 100, 0.1, consonant}, {"UW", 150, 0.9, vowel}}),
      rate);
}

Score towards_protrusion(std::size_t consonants) {
  constexpr double kTheta = 0.03;
  const Dominance vowel{.alpha = 1, .theta_before = kTheta, .theta_after = kTheta};
  const Dominance low{.alpha = 0.06, .theta_before = kTheta, .theta_after = kTheta};
  std::vector<DrawnSegment> segments{{"IY", 200, 0, vowel}};
  for (std::size_t i = 0; i < consonants; ++i) segments.push_back({"T", 150, 0, low});
  segments.push_back({"UW", 200, 1, vowel});
  return score_of(segments);
}

}  // namespace bimodal::synth

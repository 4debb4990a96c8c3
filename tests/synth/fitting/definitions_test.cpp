#include "synth/fitting/definitions.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bimodal::synth {
namespace {

using nlohmann::json;

/// Of parts by their names: how often each occurs, and what it asks.
struct Told {
  const char* part;
  std::size_t tokens;
  PartDynamics asked;
};

Fit fit_of(const std::vector<Told>& told) {
  Fit fit{.dynamics = std::vector<PartDynamics>(parts().size()),
          .tokens = std::vector<std::size_t>(parts().size())};
  for (const auto& [name, tokens, asked] : told) {
    const auto part = part_named(name).value();
    fit.dynamics[part] = asked;
    fit.tokens[part] = tokens;
  }
  return fit;
}

PartDynamics asking(double target, double alpha, double theta, double offset_ms) {
  return {.target = target,
          .log_alpha = std::log(alpha),
          .log_theta_before = std::log(theta),
          .log_theta_after = std::log(2 * theta),
          .offset_ms = offset_ms};
}

TEST(Definitions, HaveTheNumbersOfTheFit) {
  const auto text = definitions_json(
      std::vector{FittedMeasure{"inner_h", fit_of({{"B", 6, asking(-4.0, 2.49, 0.022, -13)}})},
                  FittedMeasure{"outer_w", fit_of({{"rest", 2, asking(0.3, 0.7, 0.01, 8)}})}},
      std::vector<std::string>{"six clips"});
  EXPECT_EQ(json::parse(text), json::parse(R"({
    "definitions": {
      "B": {"inner_h": {"target": -4.0, "alpha": 2.49, "theta_before_per_ms": 0.022,
                        "theta_after_per_ms": 0.044, "exponent": 1, "offset_ms": -13.0}},
      "rest": {"outer_w": {"target": 0.3, "alpha": 0.7, "theta_before_per_ms": 0.01,
                           "theta_after_per_ms": 0.02, "exponent": 1, "offset_ms": 8.0}}},
    "about": ["six clips"]})"));
}

TEST(Definitions, OfASegmentAreTheMeanOfItsPartsByTheirTokens) {
  const auto fit =
      fit_of({{"AY start", 3, asking(12, 1, 0.02, 0)}, {"AW start", 1, asking(16, 16, 0.02, -8)}});
  const auto found = dynamics_of(fit, Phone::AA).value();
  EXPECT_DOUBLE_EQ(found.target, 13);
  EXPECT_DOUBLE_EQ(std::exp(found.log_alpha), 2);
  EXPECT_DOUBLE_EQ(std::exp(found.log_theta_after), 0.04);
  EXPECT_DOUBLE_EQ(found.offset_ms, -2);
}

TEST(Definitions, LeaveOutWhatNobodySaid) {
  const auto fit = fit_of({{"B", 1, asking(0, 1, 0.02, 0)}});
  EXPECT_FALSE(dynamics_of(fit, Phone::P));
  const auto read = json::parse(definitions_json(std::vector{FittedMeasure{"x", fit}}, {}));
  EXPECT_EQ(read["definitions"].size(), 1);
}

}  // namespace
}  // namespace bimodal::synth

#include "synth/speech/dominance.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal::synth {
namespace {

using namespace std::chrono_literals;

TEST(Dominance, IsItsMagnitudeAtThePeak) {
  const Dominance dominance{.alpha = 0.7, .theta_before = 0.009, .theta_after = 0.004};
  EXPECT_DOUBLE_EQ(dominance.at(0ms), 0.7);
}

TEST(Dominance, FallsByTheFactorEAfterOneTimeConstantOnEachSide) {
  const Dominance dominance{.alpha = 1.0, .theta_before = 0.010, .theta_after = 0.005};
  EXPECT_NEAR(dominance.at(-100ms), std::exp(-1.0), 1e-15);
  EXPECT_NEAR(dominance.at(200ms), std::exp(-1.0), 1e-15);
}

TEST(Dominance, RaisesTheDistanceInMillisecondsToItsExponent) {
  const Dominance dominance{
      .alpha = 2.0, .theta_before = 0.0004, .theta_after = 0.0001, .exponent = 2.0};
  EXPECT_NEAR(dominance.at(-50ms), 2 * std::exp(-1.0), 1e-15);
  EXPECT_NEAR(dominance.at(100ms), 2 * std::exp(-1.0), 1e-15);
}

TEST(Dominance, IsConstantOnASideWhoseRateIsZero) {
  const Dominance dominance{.alpha = 0.8, .theta_before = 0, .theta_after = 0.02};
  EXPECT_DOUBLE_EQ(dominance.at(-24h), 0.8);
}

// Equation 7: exp(-w tau) (1 + w tau), with w = .02 at 50 and 100 ms: 2/e and 3/e^2.
TEST(Dominance, FallsAsACriticallyDampedTransitionInItsOtherForm) {
  const Dominance dominance{.alpha = 0.5,
                            .theta_before = 0.02,
                            .theta_after = 0.02,
                            .form = DominanceForm::CriticallyDamped};
  EXPECT_NEAR(dominance.at(-50ms), 0.5 * 2 * std::exp(-1.0), 1e-15);
  EXPECT_NEAR(dominance.at(100ms), 0.5 * 3 * std::exp(-2.0), 1e-15);
  EXPECT_DOUBLE_EQ(dominance.at(0ms), 0.5);
}

TEST(Dominance, IsLevelAtItsPeakWhereItIsCriticallyDamped) {
  const Dominance dominance{
      .theta_before = 0.02, .theta_after = 0.02, .form = DominanceForm::CriticallyDamped};
  EXPECT_NEAR(dominance.at(-1us), 1, 1e-9);
  EXPECT_LT(1 - dominance.at(1ms), 0.001 * (1 - Dominance{.theta_after = 0.02}.at(1ms)) * 20);
}

// 68 ms at .03 and then .005: 100 ms before the peak the exponent is .03 * 68 + .005 * 32 = 2.2.
TEST(Dominance, ChangesItsRateWhereItIsInflected) {
  const Dominance dominance{.alpha = 1,
                            .theta_before = 0.03,
                            .theta_after = 0.03,
                            .inflection_ms = 68,
                            .theta_early = 0.005};
  EXPECT_NEAR(dominance.at(-60ms), std::exp(-1.8), 1e-15);
  EXPECT_NEAR(dominance.at(-100ms), std::exp(-2.2), 1e-15);
  EXPECT_NEAR(dominance.at(100ms), std::exp(-3.0), 1e-15);
}

TEST(Dominance, HasNoJumpWhereItIsInflected) {
  for (const auto form : {DominanceForm::Exponential, DominanceForm::CriticallyDamped}) {
    const Dominance dominance{.theta_before = 0.03,
                              .theta_after = 0.03,
                              .form = form,
                              .inflection_ms = 68,
                              .theta_early = 0.005};
    EXPECT_NEAR(dominance.at(-68'000'000ns), dominance.at(-68'000'001ns), 1e-7);
  }
}

// Figure 4 of Cohen & Massaro (1993): theta .035, c 1, two segments of 100 ms, targets .1 and .9.
// At a centre the other segment has exp(-3.5) = .030197: (.1 + .9 * .030197) / 1.030197 = .123450.
TEST(Blend, GivesTheCurveOfFigureFour) {
  const Dominance dominance{.alpha = 1, .theta_before = 0.035, .theta_after = 0.035};
  const std::vector<Claim> claims{{.peak = 50ms, .target = 0.1, .dominance = dominance},
                                  {.peak = 150ms, .target = 0.9, .dominance = dominance}};
  EXPECT_NEAR(blend(claims, 50ms), 0.123450, 1e-6);
  EXPECT_NEAR(blend(claims, 100ms), 0.5, 1e-15);
  EXPECT_NEAR(blend(claims, 150ms), 0.876550, 1e-6);
}

TEST(Blend, StaysFiniteWhereEveryDominanceUnderflows) {
  const Dominance narrow{.alpha = 1.0, .theta_before = 0.5, .theta_after = 0.5};
  const std::vector<Claim> claims{{.peak = 0ms, .target = 3.0, .dominance = narrow},
                                  {.peak = 1ms, .target = 3.0, .dominance = narrow}};
  EXPECT_EQ(narrow.at(1h), 0.0);
  EXPECT_DOUBLE_EQ(blend(claims, 1h), 3.0);
}

TEST(BlendProperty, NeverLeavesTheRangeOfTheTargets) {
  Random random{20'260'101};
  for (int round = 0; round < 2'000; ++round) {
    std::vector<Claim> claims(1 + random.below(12));
    for (auto& claim : claims) {
      claim = {.peak = std::chrono::milliseconds{random.below(3'000)},
               .target = 20.0 * random.uniform() - 10.0,
               .dominance = {.alpha = 0.01 + random.uniform(),
                             .theta_before = 0.05 * random.uniform(),
                             .theta_after = 0.05 * random.uniform(),
                             .exponent = 0.5 + random.uniform()}};
      if (random.below(3) == 0) claim.dominance.form = DominanceForm::CriticallyDamped;
      if (random.below(3) == 0) {
        claim.dominance.exponent = 1;
        claim.dominance.inflection_ms = 100 * random.uniform();
        claim.dominance.theta_early = 0.05 * random.uniform();
      }
    }
    const auto [lowest, highest] = std::ranges::minmax(claims, {}, &Claim::target);
    const double value = blend(claims, std::chrono::milliseconds{random.below(4'000)});
    ASSERT_GE(value, lowest.target) << "round " << round;
    ASSERT_LE(value, highest.target) << "round " << round;
  }
}

}  // namespace
}  // namespace bimodal::synth

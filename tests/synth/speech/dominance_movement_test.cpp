#include "synth/speech/dominance_movement.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"

namespace bimodal::synth {
namespace {

Dominance random_dominance(Random& random, bool is_plain) {
  Dominance dominance{.alpha = 0.01 + 3 * random.uniform(),
                      .theta_before = 0.005 + 0.05 * random.uniform(),
                      .theta_after = 0.005 + 0.05 * random.uniform()};
  if (is_plain) return dominance;
  if (random.below(3) == 0) dominance.form = DominanceForm::CriticallyDamped;
  if (random.below(3) == 0) {
    dominance.inflection_ms = 100 * random.uniform();
    dominance.theta_early = 0.05 * random.uniform();
  } else {
    dominance.exponent = 0.8 + random.uniform();
  }
  return dominance;
}

std::vector<Claim> random_claims(Random& random, std::size_t count, bool is_plain) {
  std::vector<Claim> claims;
  double time = 0;
  for (std::size_t i = 0; i < count; ++i) {
    time += 20 + 200 * random.uniform();
    claims.push_back({.peak = Milliseconds{time + 60 * random.uniform()},
                      .target = 40 * random.uniform() - 20,
                      .dominance = random_dominance(random, is_plain),
                      .segment = i});
  }
  return claims;
}

double value_at(const DominanceMovement& movement, Milliseconds time) {
  double value = 0;
  movement.at(time, std::span{&value, 1});
  return value;
}

TEST(DominanceMovementProperty, EqualsTheBlendOfItsClaimsInEveryForm) {
  Random random{20'261'122};
  for (int round = 0; round < 400; ++round) {
    const auto claims = random_claims(random, 1 + random.below(40), round % 2 == 0);
    const DominanceMovement movement{{claims}};
    for (int i = 0; i < 20; ++i) {
      const Milliseconds time{10'000 * random.uniform() - 1'000};
      ASSERT_NEAR(value_at(movement, time), blend(claims, time), 1e-12) << round;
    }
  }
}

// 10,000 segments: what is left out weighs less than N e^-40 of the whole, times a range of 40.
TEST(DominanceMovement, OfALongTextStaysWithinItsErrorBound) {
  Random random{4};
  for (const bool is_plain : {true, false}) {
    auto claims = random_claims(random, 10'000, is_plain);
    for (auto& claim : claims) claim.dominance.exponent = 1;
    const DominanceMovement movement{{claims}};
    for (int i = 0; i < 50; ++i) {
      const Milliseconds time{1.2e6 * random.uniform()};
      ASSERT_NEAR(value_at(movement, time), blend(claims, time), 1e-11) << is_plain;
    }
  }
}

TEST(DominanceMovement, IsTheNearestTargetWhereEveryDominanceUnderflows) {
  const Dominance narrow{.alpha = 1, .theta_before = 0.5, .theta_after = 0.5};
  const std::vector<Claim> claims{{.peak = Milliseconds{0}, .target = 3, .dominance = narrow},
                                  {.peak = Milliseconds{90}, .target = 5, .dominance = narrow}};
  const DominanceMovement movement{{claims}};
  EXPECT_DOUBLE_EQ(value_at(movement, std::chrono::hours{-24}), 3);
  EXPECT_DOUBLE_EQ(value_at(movement, std::chrono::hours{24}), 5);
}

TEST(DominanceMovement, ChangesNothingForACommonFactorOfAllAlphas) {
  Random random{5};
  auto claims = random_claims(random, 12, true);
  const DominanceMovement movement{{claims}};
  for (auto& claim : claims) claim.dominance.alpha *= 1e3;
  const DominanceMovement louder{{claims}};
  for (int ms = -100; ms < 3'000; ms += 7) {
    ASSERT_NEAR(value_at(movement, Milliseconds{ms}), value_at(louder, Milliseconds{ms}), 1e-12);
  }
}

TEST(DominanceMovement, ComputesControlsOfEqualDynamicsTogetherAndOthersApart) {
  Random random{6};
  const auto one = random_claims(random, 9, true);
  auto two = one;
  for (auto& claim : two) claim.target *= -2;
  const auto three = random_claims(random, 5, false);
  const DominanceMovement movement{{one, three, two}};
  for (int ms = -100; ms < 2'000; ms += 13) {
    std::vector<double> values(3);
    movement.at(Milliseconds{ms}, values);
    ASSERT_NEAR(values[0], blend(one, Milliseconds{ms}), 1e-12);
    ASSERT_NEAR(values[1], blend(three, Milliseconds{ms}), 1e-12);
    ASSERT_NEAR(values[2], -2 * values[0], 1e-12);
  }
}

}  // namespace
}  // namespace bimodal::synth

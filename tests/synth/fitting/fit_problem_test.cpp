#include "synth/fitting/fit_problem.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "synth/speech/dominance.hpp"
#include "tests/synth/fitting/generated_clips.hpp"

namespace bimodal::synth {
namespace {

using enum Phone;

/// A part's five numbers, to be moved one at a time.
constexpr std::array kNumbers{&PartDynamics::target,
                              &PartDynamics::log_alpha,
                              &PartDynamics::log_theta_before,
                              &PartDynamics::log_theta_after,
                              &PartDynamics::offset_ms};

/// The model once more, in long double and without the devices of the product, with `step` added to
/// one number of one part.
long double blend_exactly(const std::vector<SpokenPart>& spoken,
                          const std::vector<PartDynamics>& asked,
                          double time_ms,
                          std::size_t moved,
                          double PartDynamics::*number,
                          long double step) {
  long double weighted = 0;
  long double total = 0;
  for (std::size_t i = 0; i < spoken.size(); ++i) {
    const auto with_step = [&](double PartDynamics::*which) {
      const auto value = static_cast<long double>(asked[i].*which);
      return i == moved && which == number ? value + step : value;
    };
    const long double tau = static_cast<long double>(spoken[i].centre_ms) +
                            with_step(&PartDynamics::offset_ms) - static_cast<long double>(time_ms);
    long double theta = std::exp(
        with_step(tau >= 0 ? &PartDynamics::log_theta_before : &PartDynamics::log_theta_after));
    if (spoken[i].begins && tau >= 0) theta = 0;
    if (spoken[i].ends && tau < 0) theta = 0;
    const long double dominance =
        std::exp(with_step(&PartDynamics::log_alpha) - theta * std::abs(tau));
    weighted += dominance * with_step(&PartDynamics::target);
    total += dominance;
  }
  return weighted / total;
}

std::vector<PartDynamics> asked_of(const MeasuredClip& clip,
                                   const std::vector<PartDynamics>& dynamics) {
  std::vector<PartDynamics> asked;
  for (const auto& one : clip.spoken) asked.push_back(dynamics[one.part]);
  return asked;
}

TEST(BlendGradient, EqualsCentralDifferencesInLongDouble) {
  Random random{4};
  for (int round = 0; round < 20; ++round) {
    auto dynamics = random_dynamics(random, -5, 15);
    for (auto& one : dynamics) one.log_theta_after += 0.3 * random.normal();
    const auto clip =
        generated_clips(
            random, {P, AY, S, UW, EY, L, Rest, W, AE}, dynamics, {0.0}, MeasureKind::Position)
            .front();
    const auto asked = asked_of(clip, dynamics);
    std::vector<PartDynamics> gradient(asked.size());
    for (int instant = 0; instant < 10; ++instant) {
      const double time = 200 + 1'500 * random.uniform();
      const double value = blend_gradient(clip.spoken, asked, time, gradient);
      EXPECT_NEAR(value,
                  static_cast<double>(blend_exactly(clip.spoken, asked, time, 0, nullptr, 0)),
                  1e-12);
      for (std::size_t part = 0; part < asked.size(); ++part) {
        for (const auto number : kNumbers) {
          constexpr long double kStep = 1e-6L;
          const auto difference = blend_exactly(clip.spoken, asked, time, part, number, kStep) -
                                  blend_exactly(clip.spoken, asked, time, part, number, -kStep);
          ASSERT_NEAR(gradient[part].*number, static_cast<double>(difference / (2 * kStep)), 1e-9)
              << parts()[clip.spoken[part].part].name << " at " << time;
        }
      }
    }
  }
}

TEST(Blended, EqualsTheBlendOfDominanceThatTheFaceUses) {
  Random random{5};
  const auto dynamics = random_dynamics(random, -5, 15);
  const auto clip =
      generated_clips(random, {B, AW, T, IY, R}, dynamics, {0.0}, MeasureKind::Position).front();
  const auto asked = asked_of(clip, dynamics);
  std::vector<Claim> claims;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const bool begins = clip.spoken[i].begins;
    const bool ends = clip.spoken[i].ends;
    claims.push_back(
        {.peak = Milliseconds{clip.spoken[i].centre_ms + asked[i].offset_ms},
         .target = asked[i].target,
         .dominance = {.alpha = std::exp(asked[i].log_alpha),
                       .theta_before = begins ? 0 : std::exp(asked[i].log_theta_before),
                       .theta_after = ends ? 0 : std::exp(asked[i].log_theta_after)}});
  }
  for (const double time : clip.time_ms) {
    EXPECT_NEAR(blended(clip.spoken, asked, time), blend(claims, Milliseconds{time}), 1e-12);
  }
}

/// Every derivative of every residual against central differences.
void expect_true_slopes(const FitOptions& options, double lowest) {
  Random random{6};
  const auto dynamics = random_dynamics(random, lowest, 12);
  const auto clips = generated_clips(
      random, {P, AY, S, UW, EY, L, W, AE, IH}, dynamics, {0.1, -0.2, 0.3}, options.kind);
  const FitProblem problem{clips, options};
  const auto columns = problem.parameter_count();
  const auto rows = problem.residual_count();
  std::vector<double> values(columns);
  for (double& value : values) value = 0.3 * random.normal();
  std::vector<double> residuals(rows);
  std::vector<double> jacobian(rows * columns, 99.0);
  problem.evaluate(values, residuals, jacobian);
  std::vector<double> more(rows);
  std::vector<double> less(rows);
  constexpr double kStep = 1e-5;
  for (std::size_t column = 0; column < columns; ++column) {
    const double at = values[column];
    values[column] = at + kStep;
    problem.evaluate(values, more, {});
    values[column] = at - kStep;
    problem.evaluate(values, less, {});
    values[column] = at;
    for (std::size_t row = 0; row < rows; ++row) {
      ASSERT_NEAR(jacobian[row * columns + column], (more[row] - less[row]) / (2 * kStep), 2e-7)
          << "residual " << row << ", parameter " << column;
    }
  }
}

TEST(FitProblem, KnowsItsSlopesWhateverSharesATheta) {
  for (const auto theta :
       {ThetaSharing::One, ThetaSharing::Sides, ThetaSharing::Class, ThetaSharing::ClassAndSide}) {
    expect_true_slopes({.kind = MeasureKind::Position, .theta = theta}, -5);
  }
  expect_true_slopes({.theta_per_ms = 0.02, .own_talkers = false, .shrinkage = 0}, -5);
}

TEST(FitProblem, KnowsTheSlopesOfOpeningsAndTheirGains) {
  expect_true_slopes({.kind = MeasureKind::Opening}, 2);
}

TEST(FitProblem, ShowsLipsThatCollideAsShut) {
  EXPECT_EQ(shown(MeasureKind::Opening, -3, 0.5), 0);
  EXPECT_EQ(shown(MeasureKind::Opening, 3, std::log(2)), 6);
  EXPECT_EQ(shown(MeasureKind::Position, -3, 0.5), -2.5);
}

}  // namespace
}  // namespace bimodal::synth

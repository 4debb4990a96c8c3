#include "synth/fitting/fit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "tests/synth/fitting/generated_clips.hpp"

namespace bimodal::synth {
namespace {

using enum Phone;

const std::vector<Phone> kPhones{P, B, W, F, T, S, L, IY, IH, AY, EH, AE, UW, AW, EY, D, Z};

/// Least squares with hardly any pull.
constexpr double kUnshrunk = 1e-6;

/// Alphas mean something up to a common factor: by how much the logarithms differ at IH.
double log_factor(const Fit& found, const std::vector<PartDynamics>& known) {
  const auto reference = part_named("IH").value();
  return known[reference].log_alpha - found.dynamics[reference].log_alpha;
}

void expect_known(const Fit& found, const std::vector<PartDynamics>& known) {
  ASSERT_TRUE(found.converged);
  const double factor = log_factor(found, known);
  for (std::size_t part = 0; part < parts().size(); ++part) {
    if (found.tokens[part] == 0) continue;
    const auto& learnt = found.dynamics[part];
    const auto name = parts()[part].name;
    EXPECT_NEAR(learnt.target, known[part].target, 0.01) << name;
    EXPECT_NEAR(learnt.log_alpha + factor, known[part].log_alpha, 0.01) << name;
    EXPECT_NEAR(learnt.offset_ms, known[part].offset_ms, 0.1) << name;
    EXPECT_NEAR(std::exp(learnt.log_theta_before - known[part].log_theta_before), 1, 1e-3) << name;
    EXPECT_NEAR(std::exp(learnt.log_theta_after - known[part].log_theta_after), 1, 1e-3) << name;
  }
}

TEST(Fit, RecoversKnownParametersFromGeneratedTracks) {
  for (Seed seed = 1; seed <= 5; ++seed) {
    Random random{seed};
    const auto known = random_dynamics(random, -6, 6);
    const auto clips =
        generated_clips(random, kPhones, known, {0, 0, 0, 0, 0}, MeasureKind::Position);
    SCOPED_TRACE(seed);
    expect_known(fit(clips, {.own_talkers = false, .shrinkage = kUnshrunk}), known);
  }
}

TEST(Fit, RecoversThetasOfClassesAndSides) {
  Random random{11};
  auto known = random_dynamics(random, -6, 6);
  std::map<std::size_t, double> before;
  std::map<std::size_t, double> after;
  for (std::size_t part = 0; part < known.size(); ++part) {
    before.try_emplace(class_of(part), 0.4 * random.uniform() - 0.2);
    after.try_emplace(class_of(part), 0.4 * random.uniform() - 0.2);
    known[part].log_theta_before += before[class_of(part)];
    known[part].log_theta_after += after[class_of(part)];
  }
  const auto clips =
      generated_clips(random, kPhones, known, {0, 0, 0, 0, 0, 0, 0, 0}, MeasureKind::Position);
  expect_known(
      fit(clips,
          {.theta = ThetaSharing::ClassAndSide, .own_talkers = false, .shrinkage = kUnshrunk}),
      known);
}

TEST(Fit, RecoversHowTalkersDiffer) {
  Random random{12};
  const auto known = random_dynamics(random, 1, 12);
  const std::vector<double> log_gains{-0.2, 0.3, -0.1, 0.15, -0.15};  // their mean is 0
  const auto clips = generated_clips(random, kPhones, known, log_gains, MeasureKind::Opening);
  const auto found = fit(clips, {.kind = MeasureKind::Opening, .shrinkage = kUnshrunk});
  ASSERT_TRUE(found.converged);
  for (std::size_t i = 0; i < log_gains.size(); ++i) {
    EXPECT_NEAR(found.talkers[i], log_gains[i], 1e-3);
  }
  for (std::size_t part = 0; part < parts().size(); ++part) {
    if (found.tokens[part] == 0) continue;
    EXPECT_NEAR(found.dynamics[part].target, known[part].target, 0.02) << parts()[part].name;
  }
}

TEST(Fit, TellsTheTracksThatItLearntFrom) {
  Random random{13};
  const auto known = random_dynamics(random, -2, 12);
  const auto clips =
      generated_clips(random, kPhones, known, {0.2, -0.1, -0.1}, MeasureKind::Opening);
  const auto found = fit(clips, {.kind = MeasureKind::Opening, .shrinkage = kUnshrunk});
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const auto told = predicted(found, clips[i], found.talkers[i]);
    for (std::size_t k = 0; k < told.size(); ++k) {
      EXPECT_NEAR(told[k], clips[i].values[k], 0.02) << clips[i].name << " " << k;
      EXPECT_GE(told[k], 0);
    }
  }
}

TEST(Fit, GivesUnmeasuredPartsWhatTheirClassSays) {
  Random random{14};
  const auto known = random_dynamics(random, -6, 6);
  const auto clips = generated_clips(random, kPhones, known, {0, 0, 0}, MeasureKind::Position);
  const auto found = fit(clips, {.own_talkers = false});
  const auto& measured = found.dynamics[part_named("P").value()];
  const auto& unmeasured = found.dynamics[part_named("M").value()];
  EXPECT_EQ(found.tokens[part_named("P").value()], 3);
  EXPECT_EQ(found.tokens[part_named("M").value()], 0);
  EXPECT_EQ(unmeasured.log_alpha, measured.log_alpha);
  EXPECT_EQ(unmeasured.offset_ms, measured.offset_ms);
  EXPECT_NE(unmeasured.target, measured.target);
  EXPECT_EQ(found.dynamics[part_named("K").value()].log_alpha, 0);  // nor its class
}

TEST(Fit, ShrinksDeviationsTheMoreItIsAskedTo) {
  Random random{15};
  const auto known = random_dynamics(random, -6, 6);
  const auto clips = generated_clips(random, kPhones, known, {0, 0, 0}, MeasureKind::Position);
  const auto range = [&](double shrinkage) {
    const auto found = fit(clips, {.own_talkers = false, .shrinkage = shrinkage});
    const auto [least, most] = std::ranges::minmax(found.dynamics, {}, &PartDynamics::log_alpha);
    return most.log_alpha - least.log_alpha;
  };
  EXPECT_GT(range(0.1), range(1));
  EXPECT_GT(range(1), range(10));
}

TEST(Fit, OfAMeasureThatNeverChangesIsConstant) {
  Random random{16};
  auto clips = generated_clips(
      random, kPhones, random_dynamics(random, -6, 6), {0, 0}, MeasureKind::Position);
  for (auto& clip : clips) std::ranges::fill(clip.values, 7.0);
  const auto found = fit(clips, {});
  for (const double value : predicted(found, clips.front(), found.talkers.front())) {
    EXPECT_NEAR(value, 7, 1e-9);
  }
}

}  // namespace
}  // namespace bimodal::synth

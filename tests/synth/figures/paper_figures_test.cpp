// What Cohen & Massaro (1993, section 3) say of their figures, held against the model.
#include "synth/figures/paper_figures.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "synth/figures/paper_scores.hpp"

namespace bimodal::synth {
namespace {

double value(const Score& score, double time_ms, Account account = Account::Dominance) {
  return value_at({.label = "", .score = score, .account = account}, Milliseconds{time_ms});
}

/// First time from `from` on at which the control is above a value, to 0.1 ms.
double time_above(const Score& score, double limit, double from = 0) {
  double time = from;
  while (time < score.end().count() && value(score, time) <= limit) time += 0.1;
  return time;
}

double slope(const Score& score, double time_ms) {
  return (value(score, time_ms + 0.5) - value(score, time_ms - 0.5)) / 1.0;
}

double steepest(const Score& score) {
  double greatest = 0;
  for (double time = 1; time < score.end().count(); time += 0.5) {
    greatest = std::max(greatest, slope(score, time));
  }
  return greatest;
}

// By hand: the other segment has exp(-3.5) at a centre: (.1 + .9 e^-3.5) / (1 + e^-3.5).
TEST(FigureFour, ReachesNeitherTarget) {
  const auto score = two_segments({});
  const double other = std::exp(-3.5);
  EXPECT_NEAR(value(score, 50), (0.1 + 0.9 * other) / (1 + other), 1e-12);
  EXPECT_NEAR(value(score, 150), (0.9 + 0.1 * other) / (1 + other), 1e-12);
  EXPECT_NEAR(value(score, 100), 0.5, 1e-12);
  double previous = 0;
  for (double time = 50; time <= 150; time += 1) {  // gradual: rises all the way, in both halves
    EXPECT_GT(value(score, time), previous);
    previous = value(score, time);
  }
}

TEST(FigureFive, LetsTheSecondSegmentIntrudeMoreTheLessAlphaTheFirstHas) {
  double previous = 0;
  for (const double alpha : {1.0, 0.5, 0.2, 0.05}) {
    const double at_first = value(two_segments({.alpha_of_first = alpha}), 50);
    EXPECT_GT(at_first, previous) << alpha;
    previous = at_first;
  }
}

TEST(FigureSix, MovesTheTransitionTowardsTheSecondSegmentAndSteepensIt) {
  double time = 0;
  double steepness = 0;
  for (const double theta : {0.0175, 0.035, 0.07, 0.14}) {
    const auto score = two_segments({.theta_before_of_second = theta});
    const double half = time_above(score, 0.5);
    EXPECT_GT(half, time) << theta;
    EXPECT_GT(steepest(score), steepness) << theta;
    time = half;
    steepness = steepest(score);
  }
}

TEST(FigureSeven, ComesCloserToTheTargetsAndToAStepAsThePowerGrows) {
  double distance = 1;
  double steepness = 0;
  for (const double exponent : {0.5, 1.0, 1.25, 2.0}) {
    const auto score = two_segments({.exponent = exponent});
    EXPECT_LT(value(score, 50) - 0.1, distance) << exponent;
    EXPECT_GT(steepest(score), steepness) << exponent;
    distance = value(score, 50) - 0.1;
    steepness = steepest(score);
  }
  const auto step = two_segments({.exponent = 2});
  EXPECT_NEAR(value(step, 97), 0.1, 0.01);
  EXPECT_NEAR(value(step, 103), 0.9, 0.01);
}

// Natural talkers are half way 43 (/w/) to 62 ms (/u/) before the sound.
TEST(FigureEight, RoundsEarlyInStewWithTheThetaOfNaturalLipsButNotWithThePrintedOne) {
  EXPECT_NEAR(time_above(stew(0.07), 0.5) - 200, 14, 1);
  EXPECT_NEAR(time_above(stew(0.035), 0.5) - 200, -5, 1);
  EXPECT_NEAR(time_above(stew(0.020), 0.5) - 200, -45, 1);
  for (const double theta : {0.018, 0.020, 0.022}) {
    EXPECT_LT(time_above(stew(theta), 0.5), 200 - 25) << theta;
    EXPECT_GT(value(stew(theta), 140), 0.3) << theta;  // well begun at the onset of /t/
  }
  EXPECT_LT(value(stew(0.07), 140), 0.11);
}

TEST(FigureEight, LetsTheTongueReachItsPlaceForT) {
  EXPECT_GT(value(stew_tongue(0.07), 170), 0.89);
}

TEST(FiguresNineAndTen, AccelerateSixtyEightMillisecondsBeforeTheSecondVowelsCentre) {
  for (std::size_t consonants = 1; consonants <= 2; ++consonants) {
    const auto inflected = vowels_around(consonants, true);
    const auto plain = vowels_around(consonants, false);
    const auto& second = inflected.segments.back();
    ASSERT_NEAR((second.start + second.duration / 2).count() - kInflectionMs, 280, 1e-9);
    const auto change = [](const Score& score) { return slope(score, 281) / slope(score, 279); };
    EXPECT_GT(change(inflected), 3) << consonants;
    EXPECT_LT(change(plain), 1) << consonants;
    // No jump in the control itself.
    EXPECT_NEAR(value(inflected, 279.999), value(inflected, 280.001), 1e-4);
  }
}

/// How far protrusion falls between the two vowels, against its lower peak.
double trough(const Score& score) {
  double left = 0;
  double right = 0;
  double lowest = 1;
  const double middle = score.end().count() / 2;
  for (double time = 0; time <= score.end().count(); time += 0.5) {
    const double now = value(score, time);
    (time < middle ? left : right) = std::max(time < middle ? left : right, now);
    const auto& t = score.segments[1];
    if (time >= t.start.count() && time <= t.end().count()) lowest = std::min(lowest, now);
  }
  return std::min(left, right) - lowest;
}

TEST(FigureEleven, ShowsTwoGesturesWhenSlowASmallerTroughAndNearlyOneGestureWhenFast) {
  EXPECT_GT(trough(utu(0.5)), 0.6);
  EXPECT_LT(trough(utu(1)), 0.75 * trough(utu(0.5)));
  EXPECT_GT(trough(utu(1)), 0.2);
  EXPECT_LT(trough(utu(2)), 0.2);
}

TEST(FigureEleven, MakesAPlateauOfTheTroughByTheAlphaOfT) {
  EXPECT_GT(trough(utu(1, 0.15)), 0.2);
  EXPECT_LT(trough(utu(1, 0.01)), 0.05);
}

TEST(FigureOne, BeginsEarlierWithMoreConsonantsOnlyWhereItLooksAhead) {
  const auto lead = [](Account account, std::size_t consonants, double part) {
    const auto score = towards_protrusion(consonants);
    double time = 0;
    while (value(score, time, account) <= part) time += 0.5;
    return score.segments.back().start.count() - time;
  };
  EXPECT_NEAR(lead(Account::LookAhead, 2, 0.02) - lead(Account::LookAhead, 1, 0.02), 150, 15);
  EXPECT_NEAR(lead(Account::TimeLocked, 2, 0.02) - lead(Account::TimeLocked, 1, 0.02), 0, 3);
  EXPECT_NEAR(lead(Account::Hybrid, 2, 0.005) - lead(Account::Hybrid, 1, 0.005), 150, 15);
  EXPECT_NEAR(lead(Account::Hybrid, 2, 0.5) - lead(Account::Hybrid, 1, 0.5), 0, 3);
}

TEST(PaperFigures, AreDrawnAsDocumentsWithTitleAndCaption) {
  const auto figures = paper_figures();
  EXPECT_EQ(figures.size(), 10);
  for (const auto& figure : figures) {
    const auto svg = svg_of(drawn(figure));
    EXPECT_NE(svg.find("<title>"), std::string::npos) << figure.name;
    EXPECT_NE(svg.find("</svg>"), std::string::npos) << figure.name;
    EXPECT_EQ(svg, svg_of(drawn(figure))) << figure.name;
    EXPECT_EQ(svg.find(" nan "), std::string::npos) << figure.name;
  }
}

}  // namespace
}  // namespace bimodal::synth

#include "synth/speech/articulation.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/random.hpp"
#include "synth/speech/claims.hpp"
#include "tests/synth/said_utterance.hpp"

namespace bimodal::synth {
namespace {

using namespace std::chrono_literals;
using enum Phone;

const SegmentTable& english() {
  static const SegmentTable table{asset("synth/assets/segments/english.json")};
  return table;
}

Utterance random_utterance(Random& random) {
  std::vector<Said> sequence{{Rest, std::chrono::milliseconds{2 * random.below(200)}}};
  const auto length = 1 + random.below(7);
  for (std::uint64_t i = 0; i < length; ++i) {
    const auto phone = all_phones()[1 + random.below(kPhoneCount - 1)];
    // Even numbers of ms (of 40 ms for a diphthong), so that centres are whole nanoseconds.
    sequence.push_back({phone, std::chrono::milliseconds{40 * (1 + random.below(6))}});
  }
  sequence.push_back({Rest, 300ms});
  return utterance_of(sequence);
}

/// Equations 1 to 6 of Cohen & Massaro (1993) written down once more, in long double and without
/// any of the class's devices: the sum over all segments of alpha exp(-theta |tau|) T, by the sum
/// without T; tau = t_c + t_o - t; theta before the peak where tau >= 0.
long double equation_six(const Utterance& utterance, Control control, long double t_ms) {
  struct Segment {
    Phone phone;
    long double start;
    long double duration;
  };

  std::vector<Segment> segments;
  for (const auto& timed : utterance.phones) {
    const auto parts = face_segments(timed.phone);
    const long double start = static_cast<long double>(timed.start.count()) / 1e6L;
    const long double duration = static_cast<long double>(timed.duration.count()) / 1e6L;
    if (parts.size() == 1) {
      segments.push_back({timed.phone, start, duration});
    } else {
      segments.push_back({parts[0], start, duration * 0.55L});
      segments.push_back({parts[1], start + duration * 0.55L, duration * 0.45L});
    }
  }
  long double weighted = 0;
  long double total = 0;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto& [phone, start, duration] = segments[s];
    const auto& asked = english().at(phone, control);
    long double centre = start + duration / 2;
    long double before = asked.dominance.theta_before;
    long double after = asked.dominance.theta_after;
    if (s == 0) {  // the rest before speech: constant until 100 ms before it
      centre = start + duration - 100;
      before = 0;
    } else if (s + 1 == segments.size()) {
      centre = start + 100;
      after = 0;
    }
    const long double offset = static_cast<long double>(asked.offset.count());
    const long double tau = centre + offset - t_ms;
    const long double dominance =
        asked.dominance.alpha * std::exp(-(tau >= 0 ? before : after) * std::abs(tau));
    weighted += dominance * asked.target;
    total += dominance;
  }
  return weighted / total;
}

TEST(Articulation, EqualsEquationSixForEveryControl) {
  Random random{19'930'139};
  for (int round = 0; round < 200; ++round) {
    const auto utterance = random_utterance(random);
    const Articulation articulation{utterance, english()};
    for (int instant = 0; instant < 20; ++instant) {
      const auto time = std::chrono::milliseconds{random.below(2'500)} - 500ms;
      const Pose pose = articulation.at(time);
      for (const auto& control : controls().first<kSpeechControlCount>()) {
        const auto exact =
            equation_six(utterance, control.control, static_cast<long double>(time.count()));
        ASSERT_NEAR(value(pose, control.control), static_cast<double>(exact), 1e-12)
            << control.name << " round " << round;
      }
    }
  }
}

TEST(Articulation, EqualsTheBlendOfItsClaims) {
  const auto utterance =
      utterance_of({{Rest, 200ms}, {S, 110ms}, {T, 70ms}, {OY, 230ms}, {Rest, 200ms}});
  const Articulation articulation{utterance, english()};
  const auto segments = segments_of(utterance);
  for (Duration time = -100ms; time < 1s; time += 7ms) {
    for (const auto& control : controls().first<kSpeechControlCount>()) {
      ASSERT_NEAR(value(articulation.at(time), control.control),
                  blend(claims_on(control.control, segments, english()), time),
                  1e-12);
    }
  }
}

TEST(Articulation, NeverLeavesTheRangeOfItsTargets) {
  Random random{7};
  for (int round = 0; round < 300; ++round) {
    const auto utterance = random_utterance(random);
    const Articulation articulation{utterance, english()};
    const auto segments = segments_of(utterance);
    const auto time = std::chrono::milliseconds{random.below(4'000)} - 1s;
    const Pose pose = articulation.at(time);
    for (const auto& control : controls().first<kSpeechControlCount>()) {
      const auto claims = claims_on(control.control, segments, english());
      const auto [lowest, highest] = std::ranges::minmax(claims, {}, &Claim::target);
      ASSERT_GE(value(pose, control.control), lowest.target - 1e-12) << control.name;
      ASSERT_LE(value(pose, control.control), highest.target + 1e-12) << control.name;
    }
  }
}

/// The steepest that a blend can be, per ms: its slope is the covariance, under the weights, of the
/// targets and of the slopes of ln D, and a covariance is at most a quarter of the product of the
/// two ranges.
double steepest(const std::vector<Claim>& claims) {
  const auto [lowest, highest] = std::ranges::minmax(claims, {}, &Claim::target);
  double before = 0;
  double after = 0;
  for (const auto& claim : claims) {
    before = std::max(before, claim.dominance.theta_before);
    after = std::max(after, claim.dominance.theta_after);
  }
  return (highest.target - lowest.target) * (before + after) / 4;
}

TEST(Articulation, MovesWithoutJumps) {
  Random random{8};
  for (int round = 0; round < 20; ++round) {
    const auto utterance = random_utterance(random);
    const Articulation articulation{utterance, english()};
    const auto segments = segments_of(utterance);
    for (const auto& control : controls().first<kSpeechControlCount>()) {
      const double limit = steepest(claims_on(control.control, segments, english()));
      double previous = value(articulation.at(-100ms), control.control);
      for (Duration time = -99ms; time < 1s; time += 1ms) {
        const double present = value(articulation.at(time), control.control);
        ASSERT_LE(std::abs(present - previous), limit + 1e-12)
            << control.name << " at " << time.count();
        previous = present;
      }
    }
  }
}

TEST(Articulation, IsDefinedAndFiniteAtAllTimes) {
  const Articulation articulation{
      utterance_of({{Rest, 200ms}, {S, 100ms}, {IY, 200ms}, {Rest, 200ms}}), english()};
  for (const Duration time :
       {Duration{-24h}, Duration{-1s}, Duration{0}, Duration{1s}, Duration{24h}}) {
    for (const double value : articulation.at(time)) EXPECT_TRUE(std::isfinite(value));
  }
}

TEST(Articulation, RestsLongBeforeAndLongAfterSpeech) {
  const Articulation articulation{
      utterance_of({{Rest, 200ms}, {W, 100ms}, {AA, 200ms}, {Rest, 200ms}}), english()};
  for (const Duration time : {Duration{-5s}, Duration{6s}}) {
    const Pose pose = articulation.at(time);
    for (std::size_t i = 0; i < kControlCount; ++i) {
      EXPECT_NEAR(pose.at(i), neutral_pose().at(i), 1e-6) << controls()[i].name;
    }
  }
}

TEST(Articulation, DoesNotDependOnTheLengthOfThePausesAroundSpeech) {
  const Articulation brief{utterance_of({{Rest, 60ms}, {W, 100ms}, {AA, 200ms}, {Rest, 30ms}}),
                           english()};
  const Articulation longer{
      utterance_of({{Rest, 400ms}, {Rest, 660ms}, {W, 100ms}, {AA, 200ms}, {Rest, 2s}}), english()};
  for (Duration time = -200ms; time < 700ms; time += 10ms) {
    const Pose one = brief.at(time);
    const Pose other = longer.at(time + 1s);
    for (std::size_t i = 0; i < kControlCount; ++i) EXPECT_NEAR(one.at(i), other.at(i), 1e-12);
  }
}

TEST(Articulation, OfNothingIsRest) {
  const Articulation articulation{Utterance{}, english()};
  EXPECT_EQ(articulation.at(0ms), neutral_pose());
  EXPECT_TRUE(articulation.sample(Hertz{60}).empty());
}

TEST(Articulation, LeavesNeutralWhatSpeechDoesNotSet) {
  const Articulation articulation{utterance_of({{Rest, 200ms}, {AA, 200ms}, {Rest, 200ms}}),
                                  english()};
  const Pose pose = articulation.at(300ms);
  for (std::size_t i = kSpeechControlCount; i < kControlCount; ++i) {
    EXPECT_EQ(pose.at(i), controls()[i].neutral);
  }
}

TEST(Articulation, SamplesAtFramesBeforeItsEnd) {
  const Articulation articulation{utterance_of({{Rest, 200ms}, {AA, 250ms}, {Rest, 50ms}}),
                                  english()};
  const auto poses = articulation.sample(Hertz{60});  // 500 ms: frames 0 to 29; frame 30 is its end
  ASSERT_EQ(poses.size(), 30);
  EXPECT_EQ(poses.at(12), articulation.at(200ms));
  EXPECT_EQ(poses.at(1), articulation.at(Milliseconds{1e3 / 60}));
  EXPECT_EQ(articulation.sample(Hertz{59.94}).size(), 30);  // frame 29 at 483.8 ms
}

TEST(SegmentsOf, DivideADiphthongFiftyFiveToFortyFive) {
  const auto segments = segments_of(utterance_of({{Rest, 100ms}, {AY, 200ms}, {Rest, 100ms}}));
  ASSERT_EQ(segments.size(), 4);
  EXPECT_EQ(segments[1].segment, Segment{AA});
  EXPECT_EQ(segments[2].segment, Segment{IH});
  EXPECT_EQ(segments[1].start, 100ms);
  EXPECT_NEAR(segments[1].duration.count(), 110, 1e-9);
  EXPECT_NEAR(segments[2].start.count(), 210, 1e-9);
  EXPECT_NEAR(segments[2].end().count(), 300, 1e-9);
  EXPECT_EQ(segments[3].start, 300ms);
}

TEST(SegmentsOf, JoinNeighbouringRests) {
  const auto segments =
      segments_of(utterance_of({{Rest, 10ms}, {Rest, 20ms}, {S, 100ms}, {Rest, 5ms}}));
  ASSERT_EQ(segments.size(), 3);
  EXPECT_EQ(segments.front(), (TimedSegment{.segment = Rest, .start = 0ms, .duration = 30ms}));
}

}  // namespace
}  // namespace bimodal::synth

// Accounts of coarticulation, and what tells them apart.
#include "synth/speech/account.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/random.hpp"
#include "synth/speech/articulation.hpp"
#include "synth/speech/claims.hpp"
#include "synth/speech/rival_movements.hpp"
#include "synth/speech/score.hpp"

namespace bimodal::synth {
namespace {

using namespace std::chrono_literals;
using enum Phone;

const SegmentTable& english() {
  static const SegmentTable table{asset("synth/assets/segments/english.json")};
  return table;
}

Utterance spoken(const std::vector<Phone>& phones, Duration consonant, Duration vowel = 200ms) {
  Utterance utterance{{{.phone = Rest, .start = 0ms, .duration = 300ms}}};
  for (const Phone phone : phones) {
    utterance.phones.push_back({.phone = phone,
                                .start = utterance.end(),
                                .duration = is_vowel(phone) ? vowel : consonant});
  }
  utterance.phones.push_back({.phone = Rest, .start = utterance.end(), .duration = 300ms});
  return utterance;
}

/// How long before the acoustic onset of the last vowel protrusion has covered `part` of the way
/// from the first vowel to its greatest value.
double lead_ms(Account account, const Utterance& utterance, double part) {
  const Articulation articulation{utterance, english(), account};
  const auto& second = utterance.phones[utterance.phones.size() - 2];
  const auto protrusion = [&](Milliseconds time) {
    return value(articulation.at(time), Control::LipProtrusion);
  };
  const Milliseconds first = utterance.phones[1].start + utterance.phones[1].duration / 2;
  const double low = protrusion(first);
  const double high = protrusion(second.start + second.duration / 2);
  for (Milliseconds time = first; time < second.end(); time += Milliseconds{0.5}) {
    if (protrusion(time) - low > part * (high - low)) {
      return (Milliseconds{second.start} - time).count();
    }
  }
  return 0;
}

/// Slope of the lead on the duration of what stands between the vowels, from /i C u/ to /i CCC u/.
double slope(Account account,
             double part,
             const std::vector<std::chrono::milliseconds>& durations = {60ms, 80ms, 100ms}) {
  std::vector<std::pair<double, double>> points;
  for (const auto& between : std::vector<std::vector<Phone>>{{T}, {S, T}, {T, S, T}}) {
    for (const auto consonant : durations) {
      std::vector<Phone> phones{IY};
      phones.insert(phones.end(), between.begin(), between.end());
      phones.push_back(UW);
      const double duration =
          static_cast<double>(between.size()) * static_cast<double>(consonant.count());
      points.emplace_back(duration, lead_ms(account, spoken(phones, consonant), part));
    }
  }
  double mean_x = 0;
  double mean_y = 0;
  for (const auto& [x, y] : points) {
    mean_x += x / static_cast<double>(points.size());
    mean_y += y / static_cast<double>(points.size());
  }
  double covariance = 0;
  double variance = 0;
  for (const auto& [x, y] : points) {
    covariance += (x - mean_x) * (y - mean_y);
    variance += (x - mean_x) * (x - mean_x);
  }
  return covariance / variance;
}

TEST(Accounts, AreFoundByTheirNames) {
  for (const auto& row : accounts()) EXPECT_EQ(account_from_name(row.name), row.account);
  EXPECT_EQ(account_from_name("ahead"), std::nullopt);
}

TEST(Accounts, OfLookAheadBeginEarlierTheMoreConsonantsPrecede) {
  EXPECT_NEAR(slope(Account::LookAhead, 0.02), 1, 0.1);
}

TEST(Accounts, OfTimeLockedGesturesBeginAFixedTimeAhead) {
  EXPECT_NEAR(slope(Account::TimeLocked, 0.02), 0, 0.1);
  EXPECT_NEAR(slope(Account::TimeLocked, 0.5), 0, 0.1);
}

TEST(Accounts, OfTheHybridBeginEarlyAndFinishAFixedTimeAhead) {
  // Its fast phase takes 185 ms here: only longer consonants leave time for the slow one.
  EXPECT_NEAR(slope(Account::Hybrid, 0.005, {200ms, 240ms}), 1, 0.1);
  EXPECT_NEAR(slope(Account::Hybrid, 0.5, {200ms, 240ms}), 0, 0.01);
}

TEST(Accounts, OfTheHybridAccelerateBetweenTheirPhases) {
  const auto utterance = spoken({IY, T, S, T, UW}, 120ms);
  const Articulation articulation{utterance, english(), Account::Hybrid};
  const Milliseconds onset = utterance.phones[5].start;
  const Milliseconds fast = onset - Milliseconds{3.7 / 0.02};
  const auto speed = [&](Milliseconds time) {
    return (value(articulation.at(time + 1ms), Control::LipProtrusion) -
            value(articulation.at(time - 1ms), Control::LipProtrusion)) /
           2;
  };
  EXPECT_GT(speed(fast - 60ms), 0);
  EXPECT_GT(speed(fast + 90ms), 4 * speed(fast - 60ms));
}

TEST(Accounts, ShutTheLipsInBilabialsWhateverSurroundsThem) {
  for (const auto& row : accounts()) {
    if (row.account == Account::Interpolation) continue;
    for (const auto& said : std::vector<std::vector<Phone>>{{AA, B, AA}, {UW, M, UW}, {S, P, IY}}) {
      const auto utterance = spoken(said, 80ms);
      const Articulation articulation{utterance, english(), row.account};
      const auto& consonant = utterance.phones[2];
      const auto middle = Milliseconds{consonant.start + consonant.duration / 2};
      EXPECT_GE(value(articulation.at(middle), Control::LipClosure), 1) << row.name;
      const Articulation dominance{utterance, english()};
      EXPECT_EQ(value(articulation.at(middle), Control::LipClosure),
                value(dominance.at(middle), Control::LipClosure))
          << row.name;
    }
  }
}

TEST(Accounts, OfAScoreShutTheLipsAsThoseOfAnUtterance) {
  const auto utterance = spoken({AA, B, AA}, 80ms);
  const auto claims = claims_of(score_of(segments_of(utterance)), english());
  const auto rows = contact_rows(claims.controls);
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : accounts()) {
    const auto movement = claims.movement(row.account);
    const Articulation articulation{utterance, english(), row.account};
    std::vector<double> values(claims.controls.size());
    movement->at(Milliseconds{550}, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto control = control_from_name(claims.controls[i]).value();
      EXPECT_EQ(values[i], value(articulation.at(Milliseconds{550}), control)) << row.name;
    }
  }
}

TEST(Accounts, OfTimeLockedGesturesKeepARoundedVowelThroughOneConsonant) {
  const auto utterance = spoken({UW, T, UW}, 60ms);
  const Articulation articulation{utterance, english(), Account::TimeLocked};
  const auto protrusion = [&](std::size_t phone) {
    const auto& timed = utterance.phones[phone];
    return value(articulation.at(Milliseconds{timed.start + timed.duration / 2}),
                 Control::LipProtrusion);
  };
  EXPECT_NEAR(protrusion(2), protrusion(1), 1e-9);
  EXPECT_NEAR(protrusion(3), protrusion(1), 1e-9);
  EXPECT_EQ(value(articulation.at(Milliseconds{0}), Control::LipProtrusion), 0);
}

TEST(Accounts, WithoutCoarticulationRunStraightFromTargetToTarget) {
  const auto utterance = spoken({IY, T, UW}, 100ms);
  const Articulation articulation{utterance, english(), Account::Interpolation};
  const auto claims = claims_on(Control::LipProtrusion, segments_of(utterance), english());
  for (std::size_t i = 0; i + 1 < claims.size(); ++i) {
    EXPECT_NEAR(
        value(articulation.at(claims[i].peak), Control::LipProtrusion), claims[i].target, 1e-12);
    EXPECT_NEAR(
        value(articulation.at((claims[i].peak + claims[i + 1].peak) / 2), Control::LipProtrusion),
        (claims[i].target + claims[i + 1].target) / 2,
        1e-12);
  }
}

// "screw driver", with a pause between: figure 6 of Kapoor et al. and its text.
TEST(Yieldings, AreThoseOfTheWorkedExample) {
  std::vector<TimedSegment> segments;
  for (const Phone phone : {Rest, S, K, R, Y, UW, Rest, D, R, AA, IH, V, ER, Rest}) {
    segments.push_back({.segment = phone,
                        .start = segments.empty() ? Milliseconds{} : segments.back().end(),
                        .duration = 80ms});
  }
  const auto yields = yieldings(claimants_of(segments));
  for (std::size_t i = 1; i <= 4; ++i) {
    EXPECT_EQ(yields[i].to, 5) << i;
    EXPECT_NEAR(yields[i].gamma, 0.5 * std::exp(-(5.0 - static_cast<double>(i)) / 5), 1e-15) << i;
  }
  for (std::size_t i = 5; i <= 12; ++i) EXPECT_EQ(yields[i].gamma, 0) << i;
}

TEST(AccountsProperty, AreContinuousFiniteAndWithinTheTargets) {
  Random random{11};
  for (int round = 0; round < 15; ++round) {
    std::vector<Phone> phones;
    const auto count = 1 + random.below(8);
    for (std::uint64_t i = 0; i < count; ++i)
      phones.push_back(all_phones()[random.below(kPhoneCount)]);
    const auto utterance = spoken(phones, std::chrono::milliseconds{20 + random.below(150)});
    for (const auto& row : accounts()) {
      const Articulation articulation{utterance, english(), row.account};
      for (const auto& control : controls().first<kSpeechControlCount>()) {
        const auto claims = claims_on(control.control, segments_of(utterance), english());
        const auto [lowest, highest] = std::ranges::minmax(claims, {}, &Claim::target);
        double previous = value(articulation.at(-1s), control.control);
        for (Milliseconds time = -100ms; time < utterance.end() + 100ms; time += 1ms) {
          const double present = value(articulation.at(time), control.control);
          ASSERT_TRUE(std::isfinite(present)) << row.name << ' ' << control.name;
          ASSERT_GE(present, lowest.target - 1e-9) << row.name << ' ' << control.name;
          ASSERT_LE(present, highest.target + 1e-9) << row.name << ' ' << control.name;
          if (time > -100ms) {
            // No jump: half of the range takes longer than 1 ms even in the briefest segment.
            ASSERT_LE(std::abs(present - previous), 0.5 * (highest.target - lowest.target) + 1e-9)
                << row.name << ' ' << control.name << " at " << time.count();
          }
          previous = present;
        }
      }
    }
  }
}

}  // namespace
}  // namespace bimodal::synth

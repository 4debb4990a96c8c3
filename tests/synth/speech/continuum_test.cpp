#include "synth/speech/continuum.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"
#include "synth/face/head.hpp"
#include "synth/speech/score_articulation.hpp"

namespace bimodal::synth {
namespace {

using ::testing::HasSubstr;
using enum Phone;

const SegmentTable& english() {
  static const SegmentTable table{asset("synth/assets/segments/english.json")};
  return table;
}

/// What the lips open to in the middle of the varied sound.
double aperture_mm(const ContinuumToken& token, const Head& head, PosedHead& posed) {
  const auto& segment = token.score.segments[token.segment];
  ScoreArticulation articulation{claims_of(token.score, english())};
  head.pose(articulation.at(segment.start + segment.duration / 2), posed);
  return posed.lips.inner_height_mm;
}

TEST(Continuum, OpensTheLipsInEveryStepFromBToW) {
  const Head head{asset("synth/assets/head")};
  PosedHead posed;
  for (const auto* const context : {"_ AA", "_ IY", "_ UW", "AA _ AA", "IY _ UW"}) {
    for (const std::size_t steps : {2U, 9U, 21U}) {
      double previous = -1;
      for (const auto& token : tokens_of(
               {.from = B, .to = Segment{W}, .steps = steps, .context = context}, english())) {
        const double aperture = aperture_mm(token, head, posed);
        EXPECT_GT(aperture, previous) << token.name << " in " << context;
        previous = aperture;
      }
    }
  }
}

TEST(Continuum, HasItsEndsAmongItsTokens) {
  const auto tokens = tokens_of({.from = B, .to = Segment{W}, .steps = 9}, english());
  ASSERT_EQ(tokens.size(), 9);
  EXPECT_EQ(tokens.front().name, "B~W:0/8");
  EXPECT_EQ(tokens.back().name, "B~W:8/8");
  for (const auto& control : controls().first<kSpeechControlCount>()) {
    const auto& first = *tokens.front().score.segments[1].segment;
    const auto& last = *tokens.back().score.segments[1].segment;
    EXPECT_EQ(english().at(first, control.control).target, english().at(B, control.control).target);
    EXPECT_EQ(english().at(last, control.control).target, english().at(W, control.control).target);
  }
}

TEST(Continuum, KeepsAllDurations) {
  const auto tokens =
      tokens_of({.from = B, .to = Segment{W}, .steps = 5, .context = "AA:150 _:90 AA"}, english());
  for (const auto& token : tokens) {
    ASSERT_EQ(token.score.segments.size(), 5);
    EXPECT_EQ(token.segment, 2);
    EXPECT_EQ(token.score.segments[2].duration.count(), 90);
    EXPECT_EQ(token.score.segments[3].duration.count(), 240);
  }
}

TEST(Continuum, FindsItsPlaceWithAndWithoutRestTyped) {
  for (const auto* const context : {"rest:100 _ AA", "_ AA", "sil _ AA rest"}) {
    const auto tokens =
        tokens_of({.from = B, .to = Segment{D}, .steps = 2, .context = context}, english());
    EXPECT_EQ(tokens.front().segment, 1) << context;
    EXPECT_EQ(tokens.front().score.segments[1].symbol, "B~D:0/1") << context;
  }
}

TEST(Continuum, AlongAControlChangesNothingElse) {
  const auto tokens = tokens_of({.from = B,
                                 .to = {},
                                 .varied = {parse_varied("cheek_puff")},
                                 .low = 0,
                                 .high = 1,
                                 .steps = 5},
                                english());
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const auto claims = claims_of(tokens[i].score, english());
    const auto plain =
        claims_of(score_of(std::vector<TimedSegment>{{Rest, Milliseconds{0}, Milliseconds{200}},
                                                     {B, Milliseconds{200}, Milliseconds{85}},
                                                     {AA, Milliseconds{285}, Milliseconds{240}},
                                                     {Rest, Milliseconds{525}, Milliseconds{200}}}),
                  english());
    for (std::size_t c = 0; c < claims.controls.size(); ++c) {
      if (claims.controls[c] == "cheek_puff") {
        EXPECT_DOUBLE_EQ(claims.claims[c][1].target, 0.25 * static_cast<double>(i));
      } else {
        EXPECT_EQ(claims.claims[c], plain.claims[c]) << claims.controls[c];
      }
    }
  }
}

// Fujimura's question: lips that open faster, all else equal.
TEST(Continuum, AlongTheSpeedOfOpeningOpensTheLipsSooner) {
  const Head head{asset("synth/assets/head")};
  PosedHead posed;
  double previous = 0;
  for (const auto& token : tokens_of({.from = B,
                           .to = {},
                           .varied = {parse_varied("lip_closure.theta_after")},
                           .low = 0.015,
                           .high = 0.06,
                           .steps = 4,
                           .context = "AA _ AA"},
                                     english())) {
    const auto claims = claims_of(token.score, english());
    const auto movement = claims.movement(Account::Dominance);
    std::vector<double> values(claims.controls.size());
    const auto closure = static_cast<std::size_t>(
        std::ranges::find(claims.controls, "lip_closure") - claims.controls.begin());
    const auto middle = token.score.segments[token.segment].start +
                        token.score.segments[token.segment].duration / 2;
    Milliseconds time = middle;
    do {
      time += Milliseconds{0.1};
      movement->at(time, values);
    } while (values[closure] > 0.5);
    if (previous > 0) {
      EXPECT_LT(time.count(), previous) << token.name;
    }
    previous = time.count();
  }
}

TEST(Continuum, RefusesWhatIsNone) {
  const auto complaint = [](const ContinuumDesign& design) -> std::string {
    try {
      static_cast<void>(tokens_of(design, english()));
    } catch (const std::exception& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_THAT(complaint({.from = B, .to = Segment{W}, .context = "AA"}), HasSubstr("0 places"));
  EXPECT_THAT(complaint({.from = B, .to = Segment{W}, .context = "_ _"}), HasSubstr("2 places"));
  EXPECT_THAT(complaint({.from = B, .to = Segment{W}, .context = "_ Q"}), HasSubstr("\"Q\""));
  EXPECT_THAT(complaint({.from = B, .to = Segment{B}}), HasSubstr("both ends are B"));
  EXPECT_THAT(complaint({.from = B, .to = Segment{W}, .steps = 1}), HasSubstr("1 steps"));
  EXPECT_THAT(complaint({.from = B, .to = {}}), HasSubstr("nothing varies"));
  const std::vector<VariedParameter> alpha{parse_varied("jaw.alpha")};
  EXPECT_THAT(complaint({.from = B, .to = {}, .varied = alpha, .low = 0, .high = 1}),
              HasSubstr("must be above 0"));
  EXPECT_THAT(complaint({.from = AY, .to = {}, .varied = alpha, .low = 1, .high = 2}),
              HasSubstr("two segments"));
  EXPECT_THROW(static_cast<void>(parse_varied("jow")), std::exception);
  EXPECT_THROW(static_cast<void>(parse_varied("jaw.speed")), std::exception);
}

}  // namespace
}  // namespace bimodal::synth

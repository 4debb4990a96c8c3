#include "synth/speech/score.hpp"

#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"
#include "synth/speech/articulation.hpp"
#include "synth/speech/durations.hpp"
#include "synth/speech/tracks.hpp"

namespace bimodal::synth {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using enum Phone;

const SegmentTable& english() {
  static const SegmentTable table{asset("synth/assets/segments/english.json")};
  return table;
}

Score read(const std::string& text) {
  std::vector<Diagnostic> diagnostics;
  auto score = parse_score(text, "score.json", diagnostics);
  EXPECT_TRUE(score) << (diagnostics.empty() ? "" : describe(diagnostics.front()));
  return score.value_or(Score{});
}

/// What is found in a score that can, or cannot, be used.
std::vector<std::string> found_in(const std::string& text, bool is_usable) {
  std::vector<Diagnostic> diagnostics;
  EXPECT_EQ(parse_score(text, "score.json", diagnostics).has_value(), is_usable);
  std::vector<std::string> found;
  for (const auto& diagnostic : diagnostics) found.push_back(describe(diagnostic));
  return found;
}

std::vector<std::string> faults(const std::string& text) {
  return found_in(text, false);
}

std::vector<std::string> warnings(const std::string& text) {
  return found_in(text, true);
}

std::string with_control(const std::string& more) {
  return "{\"segments\":[{\"symbol\":\"1\",\"duration_ms\":100,\"controls\":{\"p\":{\"target\":0.1,"
         "\"theta_before_per_ms\":0.035,\"theta_after_per_ms\":0.035" +
         more + "}}}]}";
}

TEST(Score, OfTheDocumentedFormGivesFigureFour) {
  const auto score = read(R"({"segments":[
    {"symbol":"1","duration_ms":100,"controls":{"p":{"target":0.1,"alpha":1,
     "theta_before_per_ms":0.035,"theta_after_per_ms":0.035,"exponent":1,"offset_ms":0}}},
    {"symbol":"2","duration_ms":100,"controls":{"p":{"target":0.9,"alpha":1,
     "theta_before_per_ms":0.035,"theta_after_per_ms":0.035,"exponent":1,"offset_ms":0}}}]})");
  const auto tracks = sample(claims_of(score), {.rate = Hertz{20}, .with_dominance = true});
  EXPECT_THAT(tracks.controls, ElementsAre("p"));
  EXPECT_THAT(tracks.time_ms, ElementsAre(0, 50, 100, 150));
  const double other = std::exp(-3.5);
  EXPECT_NEAR(tracks.values[0][1], (0.1 + 0.9 * other) / (1 + other), 1e-15);
  EXPECT_NEAR(tracks.dominance[0][1][1], other, 1e-15);
  EXPECT_EQ(csv_of(tracks).substr(0, 20), "time_ms,p,p@0,p@1\n0,");
}

TEST(Score, CountsAChangeOfThetaFromTheSegmentsCentreNotFromThePeak) {
  const auto score =
      read(with_control(",\"offset_ms\":-20,\"inflection_ms\":68,\"theta_early_per_ms\":0.005"));
  const auto claims = claims_of(score);
  const auto& dominance = claims.claims[0][0].dominance;
  EXPECT_DOUBLE_EQ(dominance.inflection_ms, 48);  // the peak lies at 30 ms, the change at -18
  EXPECT_DOUBLE_EQ(claims.claims[0][0].peak.count(), 30);
}

TEST(Score, AsksTheInventoryForWhatItDoesNotDefine) {
  const auto score = read(R"({"segments":[{"symbol":"rest","duration_ms":200},
    {"symbol":"S","duration_ms":140},{"symbol":"T","duration_ms":60},
    {"symbol":"UW","duration_ms":200},{"symbol":"rest","duration_ms":200}]})");
  const auto claims = claims_of(score, english());
  const auto movement = claims.movement(Account::Dominance);
  const std::vector<TimedSegment> timed{{Rest, Milliseconds{0}, Milliseconds{200}},
                                        {S, Milliseconds{200}, Milliseconds{140}},
                                        {T, Milliseconds{340}, Milliseconds{60}},
                                        {UW, Milliseconds{400}, Milliseconds{200}},
                                        {Rest, Milliseconds{600}, Milliseconds{200}}};
  const Articulation articulation{timed, english()};
  std::vector<double> values(claims.controls.size());
  for (int ms = -100; ms < 900; ms += 25) {
    movement->at(Milliseconds{ms}, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_NEAR(values[i], articulation.at(Milliseconds{ms}).at(i), 1e-12);
    }
  }
}

TEST(Score, OverridesOneControlOfASegmentAndKeepsTheOthers) {
  const auto score = read(R"({"segments":[{"symbol":"B","duration_ms":80,"controls":{"cheek_puff":
    {"target":0.8,"theta_before_per_ms":0.02,"theta_after_per_ms":0.02}}},
    {"symbol":"AA","duration_ms":200}]})");
  const auto claims = claims_of(score, english());
  for (std::size_t i = 0; i < claims.controls.size(); ++i) {
    const bool is_own = claims.controls[i] == "cheek_puff";
    ASSERT_EQ(claims.claims[i].size(), 2);
    EXPECT_EQ(claims.claims[i][0].target,
              is_own ? 0.8 : english().at(B, control_from_name(claims.controls[i]).value()).target);
  }
}

TEST(Score, TakesDefinitionsForEverySegmentOfASymbol) {
  const auto score = read(R"({"definitions":{"x":{"p":{"target":2,"theta_before_per_ms":0.02,
    "theta_after_per_ms":0.02}}},"segments":[{"symbol":"x","duration_ms":80},
    {"symbol":"x","duration_ms":80,"start_ms":100}]})");
  EXPECT_EQ(score.segments[1].start.count(), 100);
  EXPECT_EQ(score.segments[1].controls.at("p").target, 2);
}

TEST(Score, KnowsAPhoneByEveryWayToWriteIt) {
  const auto score = read(R"({"definitions":{"S":{"jaw":{"target":9,"theta_before_per_ms":0.02,
    "theta_after_per_ms":0.02}}},"segments":[{"symbol":"s","duration_ms":80}]})");
  EXPECT_EQ(score.segments[0].controls.at("jaw").target, 9);
}

TEST(Score, WarnsOfDefinitionsThatNoSegmentUses) {
  std::vector<Diagnostic> diagnostics;
  const auto score = parse_score(R"({"definitions":{"Q":{"p":{"target":9,"theta_before_per_ms":1,
    "theta_after_per_ms":1}}},"segments":[{"symbol":"S","duration_ms":80}]})",
                                 "score.json",
                                 diagnostics);
  EXPECT_TRUE(score);
  ASSERT_EQ(diagnostics.size(), 1);
  EXPECT_THAT(describe(diagnostics[0]), HasSubstr("no segment is Q;"));
}

TEST(Score, WarnsOfControlsThatAreNearlyTheFaces) {
  auto text = with_control("");
  EXPECT_TRUE(warnings(text).empty());
  text.replace(text.find("\"p\""), 3, "\"lip_clossure\"");
  EXPECT_THAT(warnings(text), ElementsAre(HasSubstr("did you mean \"lip_closure\"?")));
}

TEST(Score, RefusesControlsCalledLikeOtherColumns) {
  for (const auto* const name : {"time_ms", "p@0"}) {
    auto text = with_control("");
    text.replace(text.find("\"p\""), 3, "\"" + std::string{name} + "\"");
    EXPECT_THAT(faults(text), ElementsAre(HasSubstr("kept for a column"))) << name;
  }
}

TEST(Score, RefusesControlsBesideItsSegments) {
  auto text = with_control("");
  text.insert(1, "\"controls\":{},");
  EXPECT_THAT(faults(text), ElementsAre(HasSubstr("/controls")));
}

TEST(Score, OfTracksMovesAsTheTracksDid) {
  const std::vector<Segment> said{S, T, Segment{B, W, 3, 8}, OY, Rest, UW};
  const auto score = score_of(timed(said));
  const auto tracks = sample(claims_of(score, english()), {.rate = Hertz{100}});
  const auto text = json_of(tracks);
  const auto again = sample(claims_of(read(text)), {.rate = Hertz{100}});
  ASSERT_EQ(again.controls.size(), tracks.controls.size());
  for (std::size_t i = 0; i < again.controls.size(); ++i) {
    const auto found = std::ranges::find(tracks.controls, again.controls[i]);
    const auto& values = tracks.values[static_cast<std::size_t>(found - tracks.controls.begin())];
    for (std::size_t k = 0; k < values.size(); ++k) {
      ASSERT_NEAR(again.values[i][k], values[k], 1e-12) << again.controls[i];
    }
  }
}

TEST(Score, AtTwiceTheRateHalvesDurationsAndKeepsTheDynamics) {
  const auto score = score_of(timed(std::vector<Segment>{UW, T, UW}));
  const auto fast = claims_of(at_rate(score, 2), english());
  const auto normal = claims_of(score, english());
  EXPECT_DOUBLE_EQ(fast.end.count(), normal.end.count() / 2);
  for (std::size_t i = 1; i + 1 < normal.claimants.size(); ++i) {
    EXPECT_EQ(fast.claims[3][i].dominance, normal.claims[3][i].dominance);
    EXPECT_EQ(fast.claimants[i].start, normal.claimants[i].start / 2);
  }
}

TEST(Score, NamesEveryMistakeWithItsLine) {
  const auto found = faults(
      "{\"segments\":[\n{\"symbol\":\"Q\",\"duration_ms\":100},\n"
      "{\"symbol\":\"S\",\"duration_ms\":0},\n"
      "{\"symbol\":\"S\",\"duration_ms\":-5,\"start_ms\":-1},\n"
      "{\"symbol\":\"S\",\"duration_ms\":10,\"start_ms\":20,\"x\":1}]}");
  const auto all = fmt::format("{}", fmt::join(found, "\n"));
  EXPECT_THAT(all, HasSubstr("score.json:2: /segments/0/symbol: \"Q\" is not a phone"));
  EXPECT_THAT(all, HasSubstr("score.json:3: /segments/1/duration_ms: 0 is outside"));
  EXPECT_THAT(all, HasSubstr("score.json:4: /segments/2/duration_ms: -5 is outside"));
  EXPECT_THAT(all, HasSubstr("score.json:4: /segments/2/start_ms: -1 is outside"));
  EXPECT_THAT(all, HasSubstr("score.json:5: /segments/3/start_ms: the segment starts at 20 ms"));
  EXPECT_THAT(all, HasSubstr("score.json:5: /segments/3/x"));
}

TEST(Score, RefusesWhatCannotBeComputed) {
  EXPECT_THAT(faults(with_control(",\"alpha\":0")).front(), HasSubstr("alpha: 0 is outside"));
  EXPECT_THAT(faults(with_control(",\"alpha\":NaN")).front(), HasSubstr("score.json:1"));
  EXPECT_FALSE(faults(with_control(",\"alpha\":1e999")).empty());
  EXPECT_THAT(faults(with_control(",\"form\":\"square\"")).front(), HasSubstr("\"exponential\""));
  EXPECT_THAT(faults(with_control(",\"inflection_ms\":68")).front(),
              HasSubstr("do not stand together"));
  EXPECT_THAT(
      faults(with_control(",\"exponent\":2,\"inflection_ms\":68,\"theta_early_per_ms\":0.1"))
          .front(),
      HasSubstr("another exponent than 1"));
  EXPECT_THAT(faults("{\"segments\":[]}").front(), HasSubstr("/segments"));
  EXPECT_THAT(faults("[]").front(), HasSubstr("not an object"));
  EXPECT_THAT(faults("").front(), HasSubstr("empty"));
  EXPECT_THAT(faults(R"({"definitions":3,"segments":[{"symbol":"S","duration_ms":9}]})").front(),
              HasSubstr("not an object"));
}

TEST(Score, OfTenThousandSegmentsIsFine) {
  std::string text = "{\"segments\":[";
  for (int i = 0; i < 10'000; ++i) {
    text += fmt::format("{}{{\"symbol\":\"{}\",\"duration_ms\":{}}}",
                        i > 0 ? "," : "",
                        symbol(all_phones()[static_cast<std::size_t>(i) % kPhoneCount]),
                        50 + i % 100);
  }
  const auto score = read(text + "]}");
  const auto tracks =
      sample(claims_of(score, english()), {.rate = Hertz{10}, .controls = {"jaw", "lip_width"}});
  EXPECT_EQ(tracks.time_ms.size(), 9'950);
  for (const double value : tracks.values[0]) ASSERT_TRUE(std::isfinite(value));
}

TEST(ScoreProperty, DamagedFilesAreReadOrRefusedAndNeverBreakTheReader) {
  const std::string good = R"({"about":"x","definitions":{"x":{"p":{"target":2,"alpha":1.5,
    "theta_before_per_ms":0.02,"theta_after_per_ms":0.02,"form":"critically damped"}}},
    "segments":[{"symbol":"x","duration_ms":80,"rank":3},{"symbol":"b~w:3/8","duration_ms":70,
    "controls":{"jaw":{"target":1,"theta_before_per_ms":0.1,"theta_after_per_ms":0,"offset_ms":-3,
    "inflection_ms":6,"theta_early_per_ms":0.2}}}]})";
  Random random{77};
  int read = 0;
  for (int round = 0; round < 3'000; ++round) {
    auto text = good;
    for (std::uint64_t i = 0; i < 1 + random.below(3); ++i) {
      const auto at = random.below(text.size());
      if (random.below(2) == 0) {
        text.erase(at, 1 + random.below(6));
      } else {
        text[at] = "{}[]\",:0123456789eE.-xSTUW~/n"[random.below(29)];
      }
      if (text.empty()) text = " ";
    }
    std::vector<Diagnostic> diagnostics;
    const auto score = parse_score(text, "score.json", diagnostics);
    ASSERT_EQ(score.has_value(), !has_errors(diagnostics));
    if (!score) continue;
    ++read;
    const auto tracks =
        sample(claims_of(*score, english()), {.rate = Hertz{1}, .with_dominance = true});
    for (const auto& row : tracks.values) {
      for (const double value : row) ASSERT_TRUE(std::isfinite(value)) << text;
    }
  }
  EXPECT_GT(read, 20);
}

TEST(Tracks, RefuseToGiveAControlTwice) {
  const auto score = claims_of(read(with_control("")));
  EXPECT_THROW(static_cast<void>(sample(score, {.controls = {"p", "p"}})), Error);
}

TEST(Tracks, RefuseControlsThatTheScoreDoesNotHave) {
  const auto claims = claims_of(score_of(timed(std::vector<Segment>{S})), english());
  try {
    static_cast<void>(sample(claims, {.controls = {"jow"}}));
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean 'jaw'"));
  }
}

TEST(Durations, OfTypedSegmentsAreTheirOwnOrIntrinsic) {
  const auto segments = typed_segments("S:140 T UW0 b~w:1/4:62.5 b~w:1/4");
  ASSERT_EQ(segments.size(), 7);  // with rest around
  EXPECT_EQ(segments[1].duration.count(), 140);
  EXPECT_EQ(segments[2].duration.count(), 75);
  EXPECT_NEAR(segments[3].duration.count(), 0.7 * (210 - 35) + 35, 1e-12);
  EXPECT_EQ(segments[4].duration.count(), 62.5);
  EXPECT_NEAR(segments[5].duration.count(), 85 - 5.0 / 4, 1e-12);
  EXPECT_EQ(segments[1].start.count(), 200);
  EXPECT_EQ(segments[6].segment, Segment{Rest});
}

TEST(Durations, AreNotAddedWhereRestIsTyped) {
  const auto segments = typed_segments("rest:50 AA rest:70");
  ASSERT_EQ(segments.size(), 3);
  EXPECT_EQ(segments[2].duration.count(), 70);
}

TEST(Durations, RefuseWhatIsNoSegmentOrDuration) {
  for (const auto* const text : {"",
                                 "  ",
                                 "Q",
                                 "S:",
                                 "S:0",
                                 "S:-3",
                                 "S:nan",
                                 "S:inf",
                                 "S:1e9",
                                 "S:12x",
                                 "b~w:3/8:",
                                 ":100"}) {
    EXPECT_THROW(static_cast<void>(typed_segments(text)), std::exception) << text;
  }
}

}  // namespace
}  // namespace bimodal::synth

#include "synth/fitting/track_file.hpp"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "synth/fitting/measured_clip.hpp"

namespace bimodal::synth {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string complaints(const std::string& text, const TrackRequest& request = {}) {
  try {
    (void)parse_track(text, "x.csv", request);
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

TEST(TrackFile, HasTheColumnsOfNumbers) {
  const auto track = parse_track(
      "frame,time_s,word,inner_h,inner_h_sm,head_yaw_deg\n0,0,,1.5,1.4,0\n1,0.04,bin,-0.5,0,0\n",
      "x.csv",
      {});
  EXPECT_THAT(track.time_ms, ElementsAre(0, 40));
  ASSERT_EQ(track.columns.size(), 1);
  EXPECT_EQ(track.columns[0].name, "inner_h");
  EXPECT_THAT(track.columns[0].values, ElementsAre(1.5, -0.5));
}

TEST(TrackFile, MayHaveMillisecondsByteOrderMarkAndWindowsLines) {
  const auto track = parse_track("\xEF\xBB\xBFt_ms, jaw , lip\r\n0,1,4\r\n\r\n20,2,5\r\n",
                                 "x.csv",
                                 {.time_column = "t_ms", .columns = {"lip", "jaw"}});
  EXPECT_THAT(track.time_ms, ElementsAre(0, 20));
  EXPECT_THAT(track.column("jaw")->values, ElementsAre(1, 2));
  EXPECT_EQ(track.columns[0].name, "lip");
  EXPECT_EQ(track.column("nose"), nullptr);
}

TEST(TrackFile, WithMissingColumnsNamesThemAndThoseThatItHas) {
  EXPECT_THAT(complaints("t,inner_h\n0,1\n1,2\n", {.columns = {"outer_w"}}),
              AllOf(HasSubstr("no column time_ms or time_s"),
                    HasSubstr("--time-column"),
                    HasSubstr("x.csv:1: there is no column \"outer_w\""),
                    HasSubstr("the first line has t, inner_h")));
  EXPECT_THAT(complaints("t,inner_h\n0,1\n1,2\n", {.time_column = "t"}),
              HasSubstr("\"t\" tells no unit; let it end in _ms or _s"));
  EXPECT_THAT(complaints("time_ms,x\n0,1\n1,2\n", {.columns = {"x", "x"}}),
              HasSubstr("\"x\" is asked for twice"));
  EXPECT_THAT(complaints("time_ms,word\n0,a\n1,b\n"), HasSubstr("no column of numbers"));
}

TEST(TrackFile, TellsAllMistakesWithTheirLines) {
  const auto told =
      complaints("time_ms,inner_h\n0,1\n40,nan\n40,2\nsoon,3\n80,4,5\n120,\n160,inf\n");
  EXPECT_THAT(told,
              AllOf(HasSubstr("x.csv:3: inner_h \"nan\" is no finite number"),
                    HasSubstr("x.csv:4: the time 40 does not come after"),
                    HasSubstr("x.csv:5: the time \"soon\" is no number"),
                    HasSubstr("x.csv:6: 3 fields, but the first line has 2"),
                    HasSubstr("x.csv:7: inner_h \"\" is no finite number"),
                    HasSubstr("x.csv:8: inner_h \"inf\"")));
}

TEST(TrackFile, TellsOfManyMistakesTheFirst) {
  std::string text = "time_ms,inner_h\n0,1\n";
  for (int i = 1; i <= 50; ++i) text += std::to_string(i) + ",x\n";
  EXPECT_THAT(
      complaints(text),
      AllOf(HasSubstr("x.csv:22:"), Not(HasSubstr("x.csv:23:")), HasSubstr("... and 30 more")));
}

TEST(TrackFile, WithoutLinesIsRefused) {
  EXPECT_THAT(complaints(""), HasSubstr("x.csv: the file is empty"));
  EXPECT_THAT(complaints("time_ms,inner_h\n"), HasSubstr("no line below the names"));
  EXPECT_THAT(complaints("time_ms,inner_h\n0,1\n"), HasSubstr("one instant only"));
  EXPECT_THROW((void)read_track("nowhere.csv", {}), Error);
}

TEST(TrackFile, IsInterpolatedBetweenInstants) {
  const auto track = parse_track("time_ms,x\n0,1\n10,2\n30,6\n", "x.csv", {});
  EXPECT_EQ(interpolated(track, track.columns[0], 0), 1);
  EXPECT_EQ(interpolated(track, track.columns[0], 5), 1.5);
  EXPECT_EQ(interpolated(track, track.columns[0], 20), 4);
  EXPECT_EQ(interpolated(track, track.columns[0], 30), 6);
}

Track ramp() {
  Track track{.file = "x.csv", .columns = {{.name = "outer_w", .values = {}}}};
  for (int i = 0; i < 50; ++i) {
    track.time_ms.push_back(20.0 * i);
    track.columns[0].values.push_back(i);
  }
  return track;
}

Utterance said(Duration before, Duration speech) {
  return {{{.phone = Phone::Rest, .start = 0ms, .duration = before},
           {.phone = Phone::UW, .start = before, .duration = speech}}};
}

TEST(MeasuredClip, ReachesAHundredMillisecondsBeyondTheSpeech) {
  const auto track = ramp();
  const auto clip = measured_clip("x", track, track.columns[0], said(300ms, 200ms), "x.lab", false);
  EXPECT_EQ(clip.time_ms.front(), 200);
  EXPECT_EQ(clip.time_ms.back(), 600);
  EXPECT_EQ(clip.values.front(), 10);
  EXPECT_EQ(clip.reference, 0);
  EXPECT_EQ(coverage(clip), 1);
}

TEST(MeasuredClip, CountsFromTheMeanOverTheSpeechWhereItIsRelative) {
  const auto track = ramp();
  const auto clip = measured_clip("x", track, track.columns[0], said(300ms, 200ms), "x.lab", true);
  EXPECT_EQ(clip.reference, 19.5);  // frames 15 to 24
  EXPECT_EQ(clip.values.front(), 10 - 19.5);
}

TEST(MeasuredClip, ThatTheTrackCoversInPartSaysSo) {
  const auto track = ramp();
  const auto clip = measured_clip("x", track, track.columns[0], said(800ms, 200ms), "x.lab", true);
  EXPECT_NEAR(coverage(clip), 0.75, 1e-9);
}

TEST(MeasuredClip, WithoutSpeechInTheTrackIsRefused) {
  const auto track = ramp();
  const auto refusal = [&](const Utterance& utterance) -> std::string {
    try {
      (void)measured_clip("x", track, track.columns[0], utterance, "x.lab", true);
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_THAT(refusal(said(2s, 1s)),
              AllOf(HasSubstr("x.csv"), HasSubstr("x.lab"), HasSubstr("2.000 to 3.000 s")));
  EXPECT_THAT(refusal({}), HasSubstr("x.lab: no phone is spoken"));
}

}  // namespace
}  // namespace bimodal::synth

#include "runner/preparation/face_quality.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/preparation/drawing_pace.hpp"
#include "runner/preparation/film_studio.hpp"
#include "stimuli/timeline/inventory_file.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using protocols::FaceQuality;
using synth::Quality;
using testing::HasSubstr;
using testing::Not;

/// 4.5 s between stimuli: a film may take 2.25 s, a picture 37.5 ms.
DrawingPace pace_of(Duration picture) {
  return {.picture = picture, .picture_rate = Hertz{60}, .between_trials = 500ms};
}

TEST(FaceQuality, IsFullIfAFilmTakesAtMostHalfOfTheTimeBetweenStimuli) {
  EXPECT_EQ(film_time(pace_of(37'500us)), 2'250ms);
  EXPECT_EQ(drawing_time(pace_of(1ms)), 4'500ms);
  EXPECT_EQ(choose_quality(FaceQuality::Auto, pace_of(37'500us)).quality, Quality::Full);
  EXPECT_EQ(choose_quality(FaceQuality::Auto, pace_of(37'501us)).quality, Quality::Fast);
  EXPECT_EQ(choose_quality(FaceQuality::Auto, pace_of(1h)).basis, QualityBasis::Measured);
}

TEST(FaceQuality, ThatIsMeasuredNeverFallsAsMoreTimeIsLeftOrLessIsNeeded) {
  for (auto picture = 1ms; picture < 200ms; picture += 7ms) {
    for (const double rate : {24.0, 60.0, 144.0}) {
      for (const Duration pause : {Duration{}, Duration{500ms}, Duration{3s}}) {
        const DrawingPace pace{picture, Hertz{rate}, pause};
        if (!keeps_ahead(pace)) continue;
        EXPECT_TRUE(keeps_ahead({picture / 2, Hertz{rate}, pause}));
        EXPECT_TRUE(keeps_ahead({picture, Hertz{rate / 2}, pause}));
        EXPECT_TRUE(keeps_ahead({picture, Hertz{rate}, pause + 1s}));
      }
    }
  }
}

TEST(FaceQuality, IsThatOfTheProtocolWhateverIsMeasured) {
  for (const auto& pace : {std::optional<DrawingPace>{}, {pace_of(1us)}, {pace_of(10s)}}) {
    EXPECT_EQ(choose_quality(FaceQuality::Fast, pace).quality, Quality::Fast);
    EXPECT_EQ(choose_quality(FaceQuality::Full, pace).quality, Quality::Full);
    EXPECT_EQ(choose_quality(FaceQuality::Full, pace).basis, QualityBasis::Protocol);
  }
}

TEST(FaceQuality, IsFastWhereNobodyLooks) {
  const auto chosen = choose_quality(FaceQuality::Auto, std::nullopt);
  EXPECT_EQ(chosen.quality, Quality::Fast);
  EXPECT_EQ(chosen.basis, QualityBasis::Unwatched);
  EXPECT_THAT(describe(chosen), HasSubstr("fast quality: nobody looks at it"));
}

TEST(FaceQuality, IsMeasuredOnlyWhereSomebodyLooksAndFullMayBeDrawn) {
  EXPECT_TRUE(must_be_measured(FaceQuality::Auto, true));
  EXPECT_TRUE(must_be_measured(FaceQuality::Full, true));
  EXPECT_FALSE(must_be_measured(FaceQuality::Fast, true));
  EXPECT_FALSE(must_be_measured(FaceQuality::Auto, false));
  EXPECT_FALSE(must_be_measured(FaceQuality::Full, false));
}

TEST(FaceQuality, IsExplainedWithWhatWasMeasured) {
  const auto fast = describe(choose_quality(FaceQuality::Auto, pace_of(120ms)));
  EXPECT_EQ(fast,
            "the face is drawn in fast quality: in full quality a picture takes 120.0 ms, the film "
            "of a word about 7.2 s, more than half of the 4.5 s between stimuli");
  const auto full = describe(choose_quality(FaceQuality::Auto, pace_of(4ms)));
  EXPECT_THAT(full, HasSubstr("full quality: a picture takes 4.0 ms"));
  EXPECT_THAT(full, HasSubstr("within half"));
  EXPECT_THAT(describe(choose_quality(FaceQuality::Full, pace_of(120ms))),
              testing::AllOf(HasSubstr("full quality, as the protocol says: a picture takes 120"),
                             HasSubstr("more than half")));
  EXPECT_THAT(describe(choose_quality(FaceQuality::Full, std::nullopt)), Not(HasSubstr("takes")));
}

TEST(FaceQuality, MakesPeopleWaitOnlyIfFullIsToldToBeDrawnOnASlowMachine) {
  EXPECT_TRUE(draws_too_slowly(choose_quality(FaceQuality::Full, pace_of(120ms))));
  EXPECT_FALSE(draws_too_slowly(choose_quality(FaceQuality::Full, pace_of(4ms))));
  EXPECT_FALSE(draws_too_slowly(choose_quality(FaceQuality::Full, std::nullopt)));
  EXPECT_FALSE(draws_too_slowly(choose_quality(FaceQuality::Auto, pace_of(120ms))));
}

TEST(FaceQuality, IsMeasuredWithTheCostliestFaceThatTheTrialsShow) {
  protocols::Protocol protocol;
  protocol.window.face_height = 200;
  protocol.conditions.resize(4);
  protocol.conditions[0].auditory_talker = "festival:kal";
  protocol.conditions[1].visual_talker = "face";
  protocol.conditions[2].visual_talker = "face";
  protocol.conditions[2].look.height = 300;
  protocol.conditions[3].visual_talker = "face";
  protocol.conditions[3].look.height = 400;
  protocol.conditions[3].look.frame_rate = Hertz{25};
  const auto costliest = [&](const std::vector<std::size_t>& conditions) {
    std::vector<protocols::PlannedTrial> plan;
    for (const auto condition : conditions) plan.push_back({.condition = condition});
    const auto look = costliest_face(protocol, plan, {});
    return look ? look->height : 0;
  };
  EXPECT_EQ(costliest({0}), 0U);
  EXPECT_EQ(costliest({0, 1}), 200U);
  EXPECT_EQ(costliest({1, 2, 1}), 300U);
  EXPECT_EQ(costliest({1, 2, 3}), 300U);  // larger, but it changes seldom
  EXPECT_EQ(costliest({1, 3}), 400U);
}

TEST(FaceQuality, TakesSomeTimeAPicture) {
  EXPECT_GT(measure_full_picture({.height = 64, .lines = 64}), Duration::zero());
}

TEST(FaceQuality, IsSeen) {
  protocols::Condition condition;
  condition.visual_talker = "face";
  condition.articulating.segments = inventory_file("english");
  protocols::Window window;
  window.face_height = 96;
  const std::map<std::string, Corpus> no_corpora;
  Enactment enactment;
  enactment.length = 100ms;
  enactment.articulation = {{.segment = Phone::AA, .start = 0ms, .duration = 100ms}};
  const auto picture = [&](Quality quality) {
    FilmStudio studio{window, no_corpora, quality};
    const auto film = studio.film(condition, enactment, {.recording = 100ms}, Hertz{10}, [] {});
    return *film.pictures.back();
  };
  EXPECT_NE(picture(Quality::Fast).pixels, picture(Quality::Full).pixels);
  EXPECT_EQ(picture(Quality::Full).pixels, picture(Quality::Full).pixels);
}

}  // namespace
}  // namespace bimodal::runner

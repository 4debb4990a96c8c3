// Damaged tables of tracks become tracks or an error with the file's name, never anything else.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "synth/fitting/track_file.hpp"
#include "tests/support/damage.hpp"

namespace bimodal::synth {
namespace {

using testing::HasSubstr;

constexpr int kMutations = 10'000;

void damage_and_read(const std::string& valid, const TrackRequest& request, std::uint32_t seed) {
  Damage damage{seed};
  int accepted = 0;
  for (int i = 0; i < kMutations; ++i) {
    const auto text = damage(valid);
    try {
      const auto track = parse_track(text, "x.csv", request);
      ++accepted;
      ASSERT_GE(track.time_ms.size(), 2U);
      ASSERT_EQ(std::ranges::adjacent_find(track.time_ms, std::ranges::greater_equal{}),
                track.time_ms.end())
          << text;
      for (const auto& column : track.columns) {
        ASSERT_EQ(column.values.size(), track.time_ms.size());
        for (const double value : column.values) ASSERT_TRUE(std::isfinite(value));
        const double middle = (track.time_ms.front() + track.time_ms.back()) / 2;
        ASSERT_TRUE(std::isfinite(interpolated(track, column, middle)));
      }
    } catch (const Error& error) {
      ASSERT_THAT(error.what(), HasSubstr("x.csv"));
    }
  }
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, kMutations);
}

TEST(TrackFuzz, DamagedControlsAreTracksOrErrors) {
  damage_and_read(
      "time_ms,jaw,lip_width,jaw@2\n0,0,-1.5,1\n10,0.25,1e-3,2\n20.5,3,0,0\r\n30,4,0,0\n",
      {.time_column = {}, .columns = {"jaw", "lip_width"}},
      1);
}

TEST(TrackFuzz, DamagedMeasurementsAreTracksOrErrors) {
  damage_and_read(
      "frame,time_s,head_x,inner_height_mm,inner_height_mm_sm\n1,0,5,12.5,12\n"
      "2,0.04,5,11.5,12\n3,0.08,6,-10.25,11\n",
      {},
      2);
}

}  // namespace
}  // namespace bimodal::synth

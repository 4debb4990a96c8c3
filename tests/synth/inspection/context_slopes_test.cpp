#include "synth/inspection/context_slopes.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"

namespace bimodal::synth {
namespace {

std::vector<ContextSlope> slopes_of(const std::string& name) {
  const SegmentTable table{asset("synth/assets/segments/" + name + ".json")};
  const Head head{asset("synth/assets/head")};
  return context_slopes(table, head);
}

double slope(const std::vector<ContextSlope>& slopes,
             std::string_view consonants,
             std::string_view articulator) {
  const auto found = std::ranges::find_if(slopes, [&](const ContextSlope& one) {
    return one.consonants == consonants && one.articulator == articulator;
  });
  return found == slopes.end() ? std::nan("") : found->slope;
}

TEST(ContextSlopes, HaveAWordOnEveryNotableDifference) {
  for (const auto& one : slopes_of("english")) {
    if (std::abs(one.slope - one.measured) > kNotableDifference) {
      EXPECT_FALSE(one.word.empty())
          << one.consonants << ' ' << one.articulator << ' ' << one.slope;
    }
  }
}

TEST(ContextSlopes, OfContactsAreThoseOfConsonantsThatDecideAlone) {
  const auto slopes = slopes_of("english");
  EXPECT_NEAR(slope(slopes, "P B M", "lip opening"), 0, 0.05);
  EXPECT_NEAR(slope(slopes, "F V", "lip opening"), 0, 0.08);
}

TEST(ContextSlopes, OfRoundingAreAboutAsMeasuredForAlveolarsAndPostalveolars) {
  const auto slopes = slopes_of("english");
  EXPECT_NEAR(slope(slopes, "T D N", "lip protrusion"), 0.78, 0.1);
  EXPECT_NEAR(slope(slopes, "SH ZH", "lip protrusion"), 0.32, 0.1);
}

TEST(ContextSlopes, OfThePlateauFollowTheVowelsRoundingMore) {
  EXPECT_GT(slope(slopes_of("turkish-plateau"), "T D N", "lip protrusion"),
            slope(slopes_of("english"), "T D N", "lip protrusion") + 0.1);
}

}  // namespace
}  // namespace bimodal::synth

#include "synth/fitting/part.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/speech/claims.hpp"
#include "tests/synth/said_utterance.hpp"

namespace bimodal::synth {
namespace {

using namespace std::chrono_literals;
using enum Phone;
using testing::ElementsAre;

std::vector<std::string_view> names_of(const std::vector<SpokenPart>& spoken) {
  std::vector<std::string_view> names;
  for (const auto& one : spoken) names.push_back(parts()[one.part].name);
  return names;
}

TEST(Parts, AreOnePerPhoneOrTwoForADiphthong) {
  for (const Phone phone : all_phones()) {
    if (phone == Rest) continue;
    const auto spoken = spoken_parts(utterance_of({{phone, 100ms}}));
    const bool halved = phone == AY || phone == AW || phone == OY || phone == EY;
    ASSERT_EQ(spoken.size(), halved ? 4 : 3) << symbol(phone);
    const auto& first = parts()[spoken[1].part];
    EXPECT_TRUE(first.name.starts_with(symbol(phone))) << first.name;
    EXPECT_TRUE(halved || first.segment == phone) << first.name;
  }
}

TEST(Parts, HaveOneNameEachAndAClass) {
  for (std::size_t i = 0; i < parts().size(); ++i) {
    EXPECT_EQ(part_named(parts()[i].name), i);
    EXPECT_EQ(part_classes()[class_of(i)], parts()[i].class_name);
  }
  EXPECT_EQ(part_named("cat"), std::nullopt);
}

TEST(Parts, StandWhereTheFaceHasItsPeaks) {
  const auto utterance = utterance_of(
      {{Rest, 300ms}, {B, 80ms}, {AY, 200ms}, {Rest, 60ms}, {UW, 90ms}, {Rest, 500ms}});
  const auto spoken = spoken_parts(utterance);
  const auto segments = segments_of(utterance);
  EXPECT_THAT(names_of(spoken),
              ElementsAre("rest", "B", "AY start", "AY end", "rest", "UW", "rest"));
  ASSERT_EQ(segments.size(), spoken.size());
  for (std::size_t i = 1; i + 1 < spoken.size(); ++i) {
    EXPECT_NEAR(spoken[i].centre_ms, segments[i].centre().count(), 1e-9);
    EXPECT_FALSE(spoken[i].begins || spoken[i].ends);
  }
  EXPECT_EQ(spoken.front().centre_ms, 200);
  EXPECT_TRUE(spoken.front().begins);
  EXPECT_EQ(spoken.back().centre_ms, 830);
  EXPECT_TRUE(spoken.back().ends);
}

TEST(Parts, BeginAndEndWithRestWhereNoneIsLabelled) {
  const auto spoken = spoken_parts(utterance_of({{B, 80ms}, {UW, 90ms}}));
  EXPECT_THAT(names_of(spoken), ElementsAre("rest", "B", "UW", "rest"));
  EXPECT_EQ(spoken.front().centre_ms, -100);
  EXPECT_EQ(spoken.back().centre_ms, 270);
}

TEST(Parts, OfSilenceAreNone) {
  EXPECT_TRUE(spoken_parts(utterance_of({{Rest, 80ms}})).empty());
  EXPECT_TRUE(spoken_parts({}).empty());
}

}  // namespace
}  // namespace bimodal::synth

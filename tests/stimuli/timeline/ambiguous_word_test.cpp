#include "stimuli/timeline/ambiguous_word.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"

namespace bimodal {
namespace {

using enum Phone;
using namespace std::chrono_literals;
using testing::HasSubstr;

Utterance said(const std::vector<std::pair<Phone, Duration>>& phones) {
  Utterance utterance;
  for (const auto& [phone, duration] : phones) {
    utterance.phones.push_back({phone, utterance.end(), duration});
  }
  return utterance;
}

const Utterance kBa = said({{Rest, 200ms}, {B, 80ms}, {AA, 160ms}, {Rest, 100ms}});
const Utterance kWa = said({{Rest, 240ms}, {W, 120ms}, {AA, 200ms}, {Rest, 60ms}});

TEST(AmbiguousWord, LastsInProportion) {
  const std::vector<Segment> word{{B, W, 1, 4}, AA};
  EXPECT_EQ(between(kBa, kWa, word), said({{Rest, 210ms}, {B, 90ms}, {AA, 170ms}, {Rest, 90ms}}));
}

TEST(AmbiguousWord, IsItsEndsAtItsEnds) {
  EXPECT_EQ(between(kBa, kWa, std::vector<Segment>{{B, W, 0, 8}, AA}), kBa);
  EXPECT_EQ(between(kBa, kWa, std::vector<Segment>{{B, W, 8, 8}, AA}), kWa);
}

TEST(AmbiguousWord, TakesTheMeanWhereTwoSoundsDiffer) {
  const std::vector<Segment> word{{B, W, 1, 4}, {AA, IY, 3, 4}};
  EXPECT_DOUBLE_EQ(mean_share(word), 0.5);
  EXPECT_EQ(first_end(word), (Pronunciation{B, AA}));
  EXPECT_EQ(last_end(word), (Pronunciation{W, IY}));
  const auto wee = said({{Rest, 240ms}, {W, 120ms}, {IY, 200ms}, {Rest, 60ms}});
  EXPECT_EQ(between(kBa, wee, word), said({{Rest, 220ms}, {B, 90ms}, {IY, 190ms}, {Rest, 80ms}}));
}

TEST(AmbiguousWord, WithoutAmbiguityHasNoShare) {
  EXPECT_EQ(mean_share(std::vector<Segment>{B, AA}), 0.0);
}

TEST(AmbiguousWord, RefusesOtherNumbersAndPausesElsewhere) {
  const auto message = [](const Utterance& from, const Utterance& to) {
    try {
      static_cast<void>(between(from, to, std::vector<Segment>{{B, W, 1, 4}, AA}));
    } catch (const Error& error) {
      return std::string{error.what()};
    }
    return std::string{"none"};
  };
  EXPECT_THAT(message(kBa, said({{W, 1ms}})), HasSubstr("there are 1 sounds for 2 segments"));
  EXPECT_THAT(message(kBa, said({{W, 1ms}, {Rest, 1ms}, {Rest, 1ms}, {AA, 1ms}})),
              HasSubstr("pauses elsewhere"));
}

TEST(Articulated, PutsSegmentsInPlaceOfTheSoundsAndLeavesRests) {
  const std::vector<Segment> word{{B, W, 1, 4}, AA};
  const auto articulation = articulated(kBa, word);
  ASSERT_EQ(articulation.size(), 4U);
  EXPECT_EQ(articulation[0].segment, Segment{Rest});
  EXPECT_EQ(articulation[1].segment, word[0]);
  EXPECT_EQ(articulation[1].start, Milliseconds{200});
  EXPECT_EQ(articulation[1].duration, Milliseconds{80});
  EXPECT_EQ(articulation[2].segment, word[1]);
}

TEST(Articulated, IsThePhonesWithoutSegments) {
  const auto articulation = articulated(kBa, {});
  ASSERT_EQ(articulation.size(), 4U);
  EXPECT_EQ(articulation[1].segment, Segment{B});
  EXPECT_THROW(static_cast<void>(articulated(kBa, std::vector<Segment>{B})), Error);
}

}  // namespace
}  // namespace bimodal

#include "stimuli/timeline/phone.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "stimuli/timeline/utterance.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;

TEST(Phone, TheFaceKnowsThirteenVowelsTwentyFiveConsonantsAndRest) {
  std::set<Phone> segments;
  for (const Phone phone : all_phones()) {
    segments.insert(face_segments(phone).begin(), face_segments(phone).end());
  }
  EXPECT_EQ(std::ranges::count_if(segments, is_vowel), 13);
  EXPECT_EQ(std::ranges::count_if(segments, is_consonant), 25);
  EXPECT_EQ(segments.size(), 39U);
}

TEST(Phone, EverySymbolNamesItsPhone) {
  for (const Phone phone : all_phones()) EXPECT_EQ(phone_from_symbol(symbol(phone)), phone);
}

TEST(Phone, ReadsStressDigitsAndAnyCase) {
  EXPECT_EQ(phone_from_symbol("ah0"), Phone::AH);
  EXPECT_EQ(phone_from_symbol("pau"), Phone::Rest);
  EXPECT_EQ(phone_from_symbol("Q"), std::nullopt);
  EXPECT_EQ(phone_from_symbol(""), std::nullopt);
}

TEST(SpeechInterval, LeavesOutTheRestAtBothEnds) {
  const Utterance utterance{
      .phones = {{Phone::Rest, 0ms, 100ms}, {Phone::AY, 100ms, 200ms}, {Phone::Rest, 300ms, 50ms}}};
  EXPECT_EQ(speech_interval(utterance).start, 100ms);
  EXPECT_EQ(speech_interval(utterance).end, 300ms);
  EXPECT_EQ(utterance.end(), 350ms);
}

}  // namespace
}  // namespace bimodal

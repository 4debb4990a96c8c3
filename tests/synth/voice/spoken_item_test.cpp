#include "synth/voice/spoken_item.hpp"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"

namespace bimodal::synth {
namespace {

using namespace std::chrono_literals;
using enum Phone;

/// One second of sound at 1000 Hz.
FestivalSpeech speech_of(std::vector<FestivalSegment> segments) {
  return {.rate_hz = 1'000,
          .samples = std::vector<std::int16_t>(1'000, 16'384),
          .segments = std::move(segments)};
}

TEST(SpokenItem, HasFullScaleSamplesAtTheVoicesRate) {
  const auto item = spoken_item(speech_of({{"pau", 0.2}, {"ae", 0.5}, {"pau", 0.9}}), {});
  EXPECT_EQ(item.sound.rate, Hertz{1'000});
  EXPECT_EQ(item.sound.samples, std::vector<float>(1'000, 0.5F));
}

TEST(SpokenItem, ExtendsTheLastRestToTheEndOfTheSound) {
  const auto item = spoken_item(speech_of({{"pau", 0.2}, {"ae", 0.5}, {"pau", 0.9}}), {});
  EXPECT_EQ(item.utterance,
            (Utterance{{{.phone = Rest, .start = 0ms, .duration = 200ms},
                        {.phone = AE, .start = 200ms, .duration = 300ms},
                        {.phone = Rest, .start = 500ms, .duration = 500ms}}}));
}

TEST(SpokenItem, HalvesASyllabicConsonant) {
  const auto item =
      spoken_item(speech_of({{"pau", 0.2}, {"b", 0.3}, {"el", 0.5}, {"pau", 1.0}}), {});
  EXPECT_EQ(item.utterance.phones.at(2),
            (TimedPhone{.phone = AX, .start = 300ms, .duration = 100ms}));
  EXPECT_EQ(item.utterance.phones.at(3),
            (TimedPhone{.phone = L, .start = 400ms, .duration = 100ms}));
}

TEST(SpokenItem, NamesAReductionAsItWasAsked) {
  const auto item = spoken_item(speech_of({{"pau", 0.2}, {"ax", 0.3}, {"dx", 0.5}, {"pau", 1.0}}),
                                std::vector{AH, T});
  EXPECT_EQ(item.utterance.phones.at(1).phone, AH);
  EXPECT_EQ(item.utterance.phones.at(2).phone, T);
}

TEST(SpokenItem, RefusesAnotherWordThanAsked) {
  const auto speech = speech_of({{"pau", 0.2}, {"s", 0.3}, {"t", 0.5}, {"pau", 1.0}});
  EXPECT_THROW((void)spoken_item(speech, std::vector{S, D}), Error);
  EXPECT_THROW((void)spoken_item(speech, std::vector{S}), Error);
  EXPECT_THROW((void)spoken_item(speech, std::vector{S, T, UW}), Error);
  EXPECT_NO_THROW((void)spoken_item(speech, std::vector{S, T}));
}

TEST(SpokenItem, RefusesSegmentsThatMakeNoSense) {
  EXPECT_THROW((void)spoken_item(speech_of({}), {}), Error);
  EXPECT_THROW((void)spoken_item(speech_of({{"pau", 0.2}, {"pau", 1.0}}), {}), Error);
  EXPECT_THROW((void)spoken_item(speech_of({{"ae", 0.5}, {"t", 0.6}, {"pau", 1.0}}), {}), Error);
  EXPECT_THROW((void)spoken_item(speech_of({{"pau", 0.2}, {"ae", 0.2}, {"pau", 1.0}}), {}), Error);
  EXPECT_THROW((void)spoken_item(speech_of({{"pau", 0.2}, {"qq", 0.5}, {"pau", 1.0}}), {}), Error);
  EXPECT_THROW((void)spoken_item(speech_of({{"pau", 0.2}, {"ae", 1.5}, {"pau", 1.6}}), {}), Error);
}

}  // namespace
}  // namespace bimodal::synth

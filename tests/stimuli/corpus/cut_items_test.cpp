#include "stimuli/corpus/cut_items.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/corpus/item_sound.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::IsEmpty;

Clip hum(Duration length) {
  const auto samples = static_cast<std::size_t>(length / 62'500ns);
  Clip clip{Hertz{16'000}, std::vector<float>(samples)};
  for (std::size_t n = 0; n < samples; ++n) {
    clip.samples[n] = 0.1F * static_cast<float>(std::sin(0.3 * static_cast<double>(n)));
  }
  return clip;
}

SaidWord word(const std::string& spelling, Duration start, Duration end) {
  return {.word = spelling,
          .phones = {{Phone::B, start, 50ms}, {Phone::IY, start + 50ms, end - start - 50ms}}};
}

std::vector<CorpusItem> cut_all(const SaidWords& said, const Clip& sound) {
  return cut_items(said, sound, [](std::string_view) { return true; });
}

TEST(CutItems, HaveAHundredMillisecondsOfSilenceAround) {
  const auto items =
      cut_all({.words = {word("bee", 1s, 1300ms), word("pea", 2s, 2300ms)}}, hum(3s));
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].start, 900ms);
  EXPECT_EQ(items[0].end, 1400ms);
  EXPECT_FALSE(items[0].clear.has_value());
  EXPECT_THAT(items[0].doubt, IsEmpty());
}

TEST(CutItems, KeepClearOfANeighbourDownToFiftyMilliseconds) {
  const auto items =
      cut_all({.words = {word("bee", 1s, 1300ms), word("pea", 1370ms, 1600ms)}}, hum(3s));
  EXPECT_EQ(items[0].end, 1370ms);
  EXPECT_EQ(items[1].start, 1300ms);
  EXPECT_FALSE(items[0].clear.has_value());
  EXPECT_THAT(items[0].doubt, IsEmpty());
}

TEST(CutItems, OfRunningSpeechSayWhereTheNeighboursSound) {
  const SaidWords said{.words = {word("bee", 1s, 1300ms), word("pea", 1300ms, 1600ms)},
                       .running = true};
  const auto items = cut_all(said, hum(3s));
  EXPECT_EQ(items[0].end, 1350ms);
  EXPECT_EQ(items[0].clear, (SpeechInterval{900ms, 1300ms}));
  EXPECT_EQ(items[1].start, 1250ms);
  EXPECT_EQ(items[1].clear, (SpeechInterval{1300ms, 1700ms}));
  EXPECT_THAT(items[0].doubt, IsEmpty());
}

TEST(CutItems, OfAListAreDoubtedWhereACoughIsNear) {
  const SaidWords said{.words = {word("bee", 1s, 1300ms)}, .others = {{1320ms, 1700ms}}};
  EXPECT_THAT(cut_all(said, hum(3s)).front().doubt, HasSubstr("another sound is 20 ms after it"));
}

TEST(CutItems, AreDoubtedWhereTheRecordingEnds) {
  const auto items =
      cut_all({.words = {word("bee", 20ms, 300ms), word("pea", 2700ms, 2970ms)}}, hum(3s));
  EXPECT_THAT(items[0].doubt, HasSubstr("only 20 ms of sound before it"));
  EXPECT_EQ(items[0].start, 0ms);
  EXPECT_THAT(items[1].doubt, HasSubstr("only 30 ms of sound after it"));
  EXPECT_EQ(items[1].end, 3s);
}

TEST(CutItems, TakeTheLastGoodTakeAndDoubtTheOthers) {
  SaidWords said{.words = {word("bee", 1s, 1300ms),
                           word("bee", 2s, 2300ms),
                           word("bee", 3s, 3300ms),
                           word("pea", 4s, 4300ms)}};
  said.words[2].doubts.emplace_back("sounds more like \"tea\"");
  const auto items = cut_all(said, hum(5s));
  ASSERT_EQ(items.size(), 4U);
  EXPECT_EQ(items[0].phones.front().start, 2s);
  EXPECT_THAT(items[0].doubt, IsEmpty());
  EXPECT_EQ(items[1].doubt, "another take; the one at 2.00 s is the item");
  EXPECT_THAT(items[2].doubt, HasSubstr("sounds more like \"tea\"; another take"));
  EXPECT_EQ(items[3].word, "pea");
}

TEST(CutItems, OfRunningSpeechMayComeTwice) {
  const SaidWords said{.words = {word("bee", 1s, 1300ms), word("bee", 2s, 2300ms)},
                       .running = true};
  for (const auto& item : cut_all(said, hum(5s))) EXPECT_THAT(item.doubt, IsEmpty());
}

TEST(CutItems, AreDoubtedWhereTheSoundIsCutOff) {
  auto sound = hum(3s);
  std::fill_n(sound.samples.begin() + 17'000, 3, 1.0F);
  const auto items = cut_all({.words = {word("bee", 1s, 1300ms)}}, sound);
  EXPECT_THAT(items[0].doubt, HasSubstr("cut off at full scale in 1 place"));
}

TEST(CutItems, AreOnlyThoseThatAreWanted) {
  const SaidWords said{.words = {word("bee", 1s, 1300ms), word("pea", 2s, 2300ms)}};
  EXPECT_EQ(cut_items(said, hum(3s), [](std::string_view word) { return word == "pea"; }).size(),
            1U);
}

TEST(ItemSound, CountsRunsOfEqualSamplesAtFullScale) {
  EXPECT_EQ(clipped_runs({}), 0U);
  const std::vector<float> twice{0.F, 1.F, 1.F, 1.F, 1.F, 0.5F, -1.F, -1.F, -1.F, 0.F};
  EXPECT_EQ(clipped_runs(twice), 2U);
  const std::vector<float> peaks{0.F, 1.F, 1.F, 0.F, 0.995F, 0.996F, 0.997F, -1.F, 1.F, -1.F};
  EXPECT_EQ(clipped_runs(peaks), 0U);
}

TEST(ItemSound, MeasuresTheWordAndItsMargins) {
  auto sound = hum(3s);
  for (std::size_t n = 0; n < 16'000; ++n) sound.samples[n] *= 0.1F;
  FourierTransform fourier;
  const auto found = measure_item(sound, {900ms, 1500ms}, {1s, 1500ms}, fourier);
  EXPECT_NEAR(found.speech.count(), -23.01, 0.1);  // 0.1 sqrt(1/2)
  EXPECT_NEAR(found.before.count(), -43.01, 0.3);
  EXPECT_TRUE(std::isinf(found.after.count()));
}

}  // namespace
}  // namespace bimodal

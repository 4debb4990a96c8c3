#include "stimuli/audio/release.hpp"

#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;

/// Silence up to `burst`, then noise; murmur of 100 Hz before it if it is voiced.
Clip plosive(Duration burst, bool voiced) {
  Clip sound{.rate = Hertz{48'000}, .samples = std::vector<float>(24'000, 0.0F)};
  std::mt19937 random{1};
  const auto from = static_cast<std::size_t>(nearest_sample(burst, sound.rate).count());
  for (std::size_t i = 0; i < sound.samples.size(); ++i) {
    if (i >= from) {
      sound.samples[i] = static_cast<float>(static_cast<double>(random() % 2001) / 10'000.0 - 0.1);
    } else if (voiced) {
      sound.samples[i] =
          0.1F * std::sin(2.0F * 3.14159265F * 100.0F * static_cast<float>(i) / 48'000.0F);
    }
  }
  return sound;
}

Utterance syllable(Phone consonant, Phone vowel, Duration border) {
  return {{{Phone::Rest, 0ms, 100ms},
           {consonant, 100ms, border - 100ms},
           {vowel, border, 450ms - border},
           {Phone::Rest, 450ms, 50ms}}};
}

TEST(Release, OfAPlosiveIsItsBurstWhereverTheBorderWasDrawn) {
  for (const bool voiced : {false, true}) {
    for (const auto border : {190ms, 200ms, 215ms, 240ms}) {
      const auto found = release_of(plosive(200ms, voiced),
                                    syllable(voiced ? Phone::B : Phone::T, Phone::AA, border));
      EXPECT_NEAR(std::chrono::duration<double>{found}.count(), 0.2, 0.003)
          << "voiced " << voiced << " border " << border.count();
    }
  }
}

TEST(Release, OfAnotherConsonantIsTheStartOfTheVowel) {
  EXPECT_EQ(release_of(plosive(200ms, false), syllable(Phone::S, Phone::AA, 215ms)), 215ms);
  EXPECT_EQ(release_of(plosive(200ms, false), syllable(Phone::M, Phone::AA, 190ms)), 190ms);
}

TEST(Release, OfAPlosiveWithoutABurstIsTheStartOfTheVowel) {
  const Clip silence{.rate = Hertz{48'000}, .samples = std::vector<float>(24'000, 0.0F)};
  EXPECT_EQ(release_of(silence, syllable(Phone::B, Phone::AA, 220ms)), 220ms);
}

TEST(Release, IsThatOfTheLastConsonantOfACluster) {
  const Utterance stay{{{Phone::Rest, 0ms, 50ms},
                        {Phone::S, 50ms, 80ms},
                        {Phone::T, 130ms, 80ms},
                        {Phone::EY, 210ms, 240ms},
                        {Phone::Rest, 450ms, 50ms}}};
  EXPECT_NEAR(
      std::chrono::duration<double>{release_of(plosive(200ms, false), stay)}.count(), 0.2, 0.003);
}

TEST(Release, WithoutAConsonantIsTheStartOfTheSpeech) {
  const Utterance owe{{{Phone::Rest, 0ms, 120ms}, {Phone::OW, 120ms, 300ms}}};
  EXPECT_EQ(release_of(plosive(200ms, false), owe), 120ms);
  const Utterance hiss{{{Phone::Rest, 0ms, 80ms}, {Phone::S, 80ms, 300ms}}};
  EXPECT_EQ(release_of(plosive(200ms, false), hiss), 80ms);
}

TEST(Release, OfSilenceIsRefused) {
  EXPECT_THROW(static_cast<void>(release_of({}, {{{Phone::Rest, 0ms, 80ms}}})), Error);
}

}  // namespace
}  // namespace bimodal

#include "stimuli/alignment/aligner.hpp"

#include <functional>
#include <limits>
#include <thread>

#include <gmock/gmock.h>

#include "stimuli/audio/resample.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"
#include "tests/stimuli/alignment/spoken_words.hpp"

namespace bimodal {
namespace {

using namespace testing_alignment;
using enum Phone;
using ::testing::HasSubstr;

const Pronunciation kStew{S, T, UW};

std::string message_of(const std::function<void()>& deed) {
  try {
    deed();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::vector<Phone> phones_of(const Utterance& utterance) {
  std::vector<Phone> phones;
  for (const auto& timed : utterance.phones) phones.push_back(timed.phone);
  return phones;
}

/// Without gaps from the beginning to the end of the sound, every phone long enough.
void expect_whole(const Alignment& found, const Clip& sound) {
  Duration at{};
  for (const auto& timed : found.utterance.phones) {
    EXPECT_EQ(timed.start, at);
    EXPECT_GE(timed.duration, timed.phone == Rest ? Duration{} : std::chrono::milliseconds{30});
    at = timed.end();
  }
  EXPECT_EQ(at, sound.duration());
  EXPECT_EQ(found.utterance.phones.front().phone, Rest);
  EXPECT_EQ(found.utterance.phones.back().phone, Rest);
}

Clip noise(std::size_t samples, Hertz rate = Hertz{16'000}) {
  Random random{5};
  Clip made{rate, {}};
  for (std::size_t i = 0; i < samples; ++i) {
    made.samples.push_back(random.uniform() < 0.5 ? -1.0F : 1.0F);
  }
  return made;
}

class AlignerOfSpeech : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_voice("kal")) GTEST_SKIP() << "Festival's voice kal is missing";
    stew_ = synth::Voice{"kal"}.speak("stew", kStew);
  }

  synth::SpokenItem stew_;
  Aligner aligner_;
};

TEST_F(AlignerOfSpeech, SaysTheSameEveryTime) {
  const auto first = aligner_.align(stew_.sound, kStew);
  (void)aligner_.align(noise(16'000), kStew);
  const auto again = aligner_.align(stew_.sound, kStew);
  EXPECT_EQ(first.utterance, again.utterance);
  EXPECT_EQ(first.fit, again.fit);
  expect_whole(first, stew_.sound);
}

TEST_F(AlignerOfSpeech, DoesNotMindTheLevelOrAnOffset) {
  const auto loud = aligner_.align(stew_.sound, kStew);
  auto changed = stew_.sound;
  for (float& sample : changed.samples) sample = 0.01F * sample + 0.2F;
  const auto soft = aligner_.align(changed, kStew);
  for (const double error : boundary_errors(soft.utterance, loud.utterance)) {
    EXPECT_LE(std::abs(error), 10.0);
  }
}

TEST_F(AlignerOfSpeech, DoesNotMindTheSamplingRate) {
  const auto found = aligner_.align(stew_.sound, kStew);
  for (const double rate : {44'100.0, 48'000.0, 22'050.0}) {
    const auto other = resample(stew_.sound, Hertz{rate});
    const auto again = aligner_.align(other, kStew);
    expect_whole(again, other);
    for (const double error : boundary_errors(again.utterance, found.utterance)) {
      EXPECT_LE(std::abs(error), 10.0) << rate;
    }
  }
}

TEST_F(AlignerOfSpeech, FindsAWordThatIsCutFlush) {
  const auto speech = speech_interval(stew_.utterance);
  const auto rate = stew_.sound.rate;
  const auto first = nearest_sample(speech.start, rate).count();
  const auto last = nearest_sample(speech.end, rate).count();
  const auto& samples = stew_.sound.samples;
  const Clip flush{rate, {samples.begin() + first, samples.begin() + last}};
  const auto found = aligner_.align(flush, kStew);
  expect_whole(found, flush);
  EXPECT_EQ(phones_of(found.utterance), (std::vector{Rest, S, T, UW, Rest}));
  for (std::size_t i = 1; i < found.utterance.phones.size(); ++i) {
    EXPECT_NEAR(milliseconds(found.utterance.phones[i].start),
                milliseconds(stew_.utterance.phones[i].start - speech.start),
                50.0);
  }
}

TEST_F(AlignerOfSpeech, GivesBackOurOwnPhones) {
  const auto found = aligner_.align(stew_.sound, Pronunciation{WH, AX});
  EXPECT_EQ(phones_of(found.utterance), (std::vector{Rest, WH, AX, Rest}));
}

TEST_F(AlignerOfSpeech, TakesThePronunciationThatWasSaid) {
  const synth::Voice voice{"kal"};
  const Pronunciation past{R, EH, D};
  const Pronunciation present{R, IY, D};
  const std::vector<SpokenWord> read{{"read", {present, past}}};
  for (const auto& said : {past, present}) {
    const auto item = voice.speak("read", said);
    const auto found = aligner_.align(item.sound, read);
    EXPECT_EQ(phones_of(found.utterance).at(2), said.at(1));
  }
}

TEST_F(AlignerOfSpeech, FindsWordsInARowWithAndWithoutPauses) {
  const synth::Voice voice{"kal"};
  Clip all{stew_.sound.rate, {}};
  std::vector<SpokenWord> words_said;
  std::vector<double> begins_ms;
  for (const auto& word : words(30)) {
    const auto item = voice.speak(word.spelling, word.phones);
    const auto start = all.duration() + speech_interval(item.utterance).start;
    begins_ms.push_back(milliseconds(start));
    all.samples.insert(all.samples.end(), item.sound.samples.begin(), item.sound.samples.end());
    words_said.push_back({word.spelling, {word.phones}});
  }
  const auto found = aligner_.align(all, words_said);
  expect_whole(found, all);
  ASSERT_EQ(found.words.size(), words_said.size());
  ASSERT_EQ(found.fit_of_word.size(), words_said.size());
  std::vector<double> errors;
  for (std::size_t i = 0; i < found.words.size(); ++i) {
    const auto& word = found.words[i];
    EXPECT_EQ(word.spelling, words_said[i].spelling);
    const auto phones = phones_of(found.utterance);
    const std::span of_word{phones.data() + word.first_phone, word.phones};
    EXPECT_TRUE(std::ranges::equal(of_word, words_said[i].pronunciations.front()));
    EXPECT_LE(found.fit_of_word[i], 1e-3);
    errors.push_back(milliseconds(found.utterance.phones[word.first_phone].start) - begins_ms[i]);
  }
  EXPECT_GE(share_within(errors, 50.0), 0.8);
  EXPECT_GE(share_within(errors, 120.0), 1.0);
}

TEST_F(AlignerOfSpeech, WorksInTwoThreadsAtOnce) {
  const auto expected = aligner_.align(stew_.sound, kStew);
  const auto align_often = [&](int& same) {
    Aligner own;
    for (int i = 0; i < 5; ++i) {
      if (own.align(stew_.sound, kStew).utterance == expected.utterance) ++same;
    }
  };
  int one = 0;
  int two = 0;
  std::thread other{[&] { align_often(two); }};
  align_often(one);
  other.join();
  EXPECT_EQ(one, 5);
  EXPECT_EQ(two, 5);
}

TEST_F(AlignerOfSpeech, SurvivesAnySound) {
  Random random{8};
  for (const std::size_t samples : {1440U, 1441U, 3000U, 16'000U, 50'000U}) {
    const auto sound = noise(samples);
    expect_whole(aligner_.align(sound, kStew), sound);
    Clip click{Hertz{16'000}, std::vector<float>(samples)};
    click.samples[random.below(samples)] = 1.0F;
    expect_whole(aligner_.align(click, kStew), click);
  }
}

TEST(Aligner, RefusesWhatHoldsNoSpeech) {
  Aligner aligner;
  const auto fault = [&](const Clip& sound) {
    return message_of([&] { (void)aligner.align(sound, kStew); });
  };
  EXPECT_THAT(fault({Hertz{16'000}, {}}), HasSubstr("lasts 0 ms"));
  EXPECT_THAT(fault({Hertz{16'000}, {0.5F}}), HasSubstr("3 phones need at least 90 ms"));
  EXPECT_THAT(fault({Hertz{0.0}, {0.5F}}), HasSubstr("0 samples per second"));
  EXPECT_THAT(fault({Hertz{16'000}, std::vector<float>(16'000)}), HasSubstr("it is silent"));
  EXPECT_THAT(fault({Hertz{16'000}, std::vector<float>(16'000, 0.5F)}), HasSubstr("it is silent"));
  auto broken = noise(16'000);
  broken.samples[77] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(fault(broken), HasSubstr("sample 77 is not a finite number"));
  EXPECT_THAT(fault(noise(1000 * 601, Hertz{1000})), HasSubstr("cut it into parts at pauses"));
}

TEST(Aligner, RefusesWordsWithoutPhones) {
  Aligner aligner;
  const auto sound = noise(16'000);
  const auto fault = [&](const std::vector<SpokenWord>& words) {
    return message_of([&] { (void)aligner.align(sound, words); });
  };
  EXPECT_THAT(fault({}), HasSubstr("no words were given"));
  EXPECT_THAT(fault({{"stew", {}}}), HasSubstr("\"stew\" (no pronunciation)"));
  EXPECT_THAT(fault({{"stew", {{}}}}), HasSubstr("at least one phone"));
  EXPECT_THAT(fault({{"stew", {{S, Rest, T}}}}), HasSubstr("none of them rest"));
}

}  // namespace
}  // namespace bimodal

#include "runner/preparation/enactment.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/preparation/trial_preparer.hpp"
#include "stimuli/audio/release.hpp"
#include "stimuli/audio/sound_file.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "tests/stimuli/video/made_media.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

const Word kBa{.spelling = "ba", .phones = {Phone::B, Phone::AA}, .seen = std::nullopt};
const Word kBaSeenAsDa{.spelling = "ba",
                       .phones = {Phone::B, Phone::AA},
                       .seen = SeenWord{"da", {Phone::D, Phone::AA}}};

double milliseconds(Duration time) {
  return std::chrono::duration<double, std::milli>{time}.count();
}

/// When the phone of an utterance begins.
Duration start_of(const Utterance& utterance, Phone phone) {
  for (const auto& timed : utterance.phones) {
    if (timed.phone == phone) return timed.start;
  }
  ADD_FAILURE() << "there is no " << symbol(phone);
  return {};
}

protocols::Condition both(const std::string& auditory, const std::string& visual) {
  protocols::Condition condition;
  condition.name = "both";
  condition.auditory_talker = auditory;
  condition.visual_talker = visual;
  condition.timing_talker = auditory;
  return condition;
}

class EnactmentTest : public made_media::MadeMedia {
 protected:
  /// A corpus whose only recording is Festival saying "ba" at 0.5 s and "da" at 2 s, with video.
  void make_corpus() {
    Repertoire voice{Hertz{48'000}, none_};
    Clip sound{.rate = Hertz{48'000}, .samples = std::vector<float>(4 * 48'000, 0.0F)};
    Corpus corpus{.name = "made", .folder = path("corpus")};
    const auto add = [&](const std::string& name, Phone consonant, Duration at) {
      const auto& spoken = voice.perform("festival:kal", name, {consonant, Phone::AA});
      const auto first = static_cast<std::size_t>(nearest_sample(at, sound.rate).count());
      std::ranges::copy(spoken.sound.samples,
                        sound.samples.begin() + static_cast<std::ptrdiff_t>(first));
      CorpusItem item{.name = name, .word = name, .start = at, .end = at + spoken.length()};
      for (const auto& timed : spoken.utterance.phones) {
        if (timed.phone == Phone::Rest) continue;
        item.phones.push_back({timed.phone, timed.start + at, timed.duration});
      }
      corpus.items.push_back(item);
    };
    add("ba", Phone::B, 500ms);
    add("da", Phone::D, 2s);
    std::filesystem::create_directories(corpus.folder);
    write_wav(path("speech.wav"), sound);
    static_cast<void>(made("corpus/talk.mkv",
                           made_media::numbered_frames("25", "4") + " -i '" +
                               path("speech.wav").string() +
                               "' -c:v ffv1 -c:a pcm_f32le -shortest"));
    corpus.recordings.push_back({.file = "talk.mkv",
                                 .sha256 = sha256_of_file(corpus.folder / "talk.mkv"),
                                 .talker = "kal",
                                 .licence = "",
                                 .eye_distance_px = std::nullopt});
    corpora_.emplace("made", std::move(corpus));
  }

  std::map<std::string, Corpus> none_;
  std::map<std::string, Corpus> corpora_;
};

TEST_F(EnactmentTest, TheFaceFollowsTheVoiceThatIsHeard) {
  Repertoire repertoire{Hertz{48'000}, none_};
  const auto enactment = enact(both("festival:kal", "face"), kBa, repertoire);
  EXPECT_EQ(enactment.heard, enactment.seen);
  EXPECT_EQ(enactment.length, enactment.sound->duration());
  EXPECT_EQ(enactment.release, std::nullopt);
}

TEST_F(EnactmentTest, ARecordingIsHeardAndSeenOnItsOwnTime) {
  make_corpus();
  Repertoire repertoire{Hertz{48'000}, corpora_};
  const auto enactment = enact(both("corpus:made", "corpus:made"), kBa, repertoire);
  EXPECT_EQ(enactment.picture_source->span.start, 500ms);
  EXPECT_EQ(enactment.picture_start, 0ms);
  EXPECT_EQ(recording_time(enactment, 100ms), 600ms);
  // The very samples that Festival spoke.
  Repertoire voice{Hertz{48'000}, none_};
  const auto& spoken = voice.perform("festival:kal", "ba", kBa.phones);
  ASSERT_EQ(enactment.sound->samples.size(), spoken.sound.samples.size());
  for (std::size_t i = 0; i < spoken.sound.samples.size(); i += 97) {
    ASSERT_NEAR(enactment.sound->samples[i], spoken.sound.samples[i], 1e-6) << i;
  }
}

TEST_F(EnactmentTest, TheFaceFollowsTheRecording) {
  make_corpus();
  Repertoire repertoire{Hertz{48'000}, corpora_};
  const auto enactment = enact(both("corpus:made", "face"), kBa, repertoire);
  EXPECT_EQ(enactment.picture_source, std::nullopt);
  EXPECT_NEAR(milliseconds(start_of(enactment.seen, Phone::AA)),
              milliseconds(start_of(utterance_of(corpora_.at("made").items[0]), Phone::AA)),
              0.001);
}

TEST_F(EnactmentTest, DubbedWordsMeetAtTheRelease) {
  make_corpus();
  Repertoire repertoire{Hertz{48'000}, corpora_};
  const auto enactment = enact(both("corpus:made", "corpus:made"), kBaSeenAsDa, repertoire);
  const auto& ba = repertoire.perform("corpus:made", "ba", {});
  const auto& da = repertoire.perform("corpus:made", "da", {});
  const auto seen_release = release_of(da.sound, da.utterance);
  ASSERT_TRUE(enactment.release.has_value());
  // What is seen at the release of what is heard is the release of "da", in the recording's time.
  EXPECT_NEAR(milliseconds(recording_time(enactment, *enactment.release)),
              milliseconds(2s + seen_release),
              0.01);
  EXPECT_NEAR(milliseconds(release_of(*enactment.sound, enactment.heard)),
              milliseconds(*enactment.release),
              1.0);
  EXPECT_GE(enactment.length, std::max(ba.length(), da.length()) - 1ms);
  EXPECT_EQ(enactment.heard.end(), enactment.seen.end());
}

TEST_F(EnactmentTest, TheFaceIsDubbedAlike) {
  Repertoire repertoire{Hertz{48'000}, none_};
  const auto enactment = enact(both("festival:kal", "face"), kBaSeenAsDa, repertoire);
  static_cast<void>(start_of(enactment.heard, Phone::B));
  static_cast<void>(start_of(enactment.seen, Phone::D));
  EXPECT_TRUE(enactment.release.has_value());
}

TEST_F(EnactmentTest, ThreeTimesAsFastIsAThirdAsLong) {
  make_corpus();
  Repertoire repertoire{Hertz{48'000}, corpora_};
  auto condition = both("corpus:made", "corpus:made");
  const auto natural = enact(condition, kBa, repertoire);
  condition.manner.rate = 3.0;
  const auto fast = enact(condition, kBa, repertoire);
  EXPECT_NEAR(milliseconds(fast.length), milliseconds(natural.length) / 3.0, 0.03);
  EXPECT_NEAR(milliseconds(start_of(fast.heard, Phone::AA)),
              milliseconds(start_of(natural.heard, Phone::AA)) / 3.0,
              0.03);
  EXPECT_NEAR(milliseconds(recording_time(fast, 20ms)), 560.0, 0.01);
}

TEST_F(EnactmentTest, ReversedEverythingRunsFromTheEnd) {
  make_corpus();
  Repertoire repertoire{Hertz{48'000}, corpora_};
  auto condition = both("corpus:made", "corpus:made");
  const auto onward = enact(condition, kBa, repertoire);
  condition.manner.reversed = true;
  const auto backward = enact(condition, kBa, repertoire);
  EXPECT_EQ(backward.length, onward.length);
  EXPECT_EQ(backward.sound->samples.front(), onward.sound->samples.back());
  EXPECT_EQ(recording_time(backward, 0ms), 500ms + onward.length);
  EXPECT_EQ(backward.heard.phones.front().duration, onward.heard.phones.back().duration);
}

TEST_F(EnactmentTest, TheGateFallsAfterAPhoneOrATimeSinceTheOnset) {
  Repertoire repertoire{Hertz{48'000}, none_};
  auto condition = both("festival:kal", "face");
  condition.manner.gate = protocols::Gate{.after_phone = 1};
  const auto after = enact(condition, kBa, repertoire);
  EXPECT_EQ(after.gate, start_of(after.heard, Phone::AA));
  condition.manner.gate = protocols::Gate{.at = 30ms};
  const auto at = enact(condition, kBa, repertoire);
  EXPECT_EQ(at.gate, start_of(at.heard, Phone::B) + 30ms);
  condition.manner.gate = protocols::Gate{.after_phone = 3};
  EXPECT_THAT(made_media::message_of([&] { static_cast<void>(enact(condition, kBa, repertoire)); }),
              HasSubstr("\"ba\" cannot be gated after phone 3: it has 2"));
}

TEST_F(EnactmentTest, AGatedWordKeepsTheLevelOfTheWholeOne) {
  protocols::Protocol protocol;
  protocol.conditions = {both("festival:kal", "face"), both("festival:kal", "face")};
  protocol.conditions[1].manner.gate = protocols::Gate{.after_phone = 1};
  Repertoire repertoire{Hertz{48'000}, none_};
  TrialPreparer preparer{protocol, repertoire, nullptr, Hertz{60}};
  const auto whole = preparer.mix_sound({.word = kBa, .condition = 0});
  const auto gated = preparer.mix_sound({.word = kBa, .condition = 1});
  EXPECT_EQ(whole->recording_level, gated->recording_level);
  const auto enactment = enact(protocol.conditions[1], kBa, repertoire);
  const auto gate = static_cast<std::size_t>(
      nearest_sample(protocol.sound.noise.lead + *enactment.gate, whole->sound.rate).count());
  for (std::size_t i = gate; i < gated->sound.samples.size(); ++i) {
    ASSERT_EQ(gated->sound.samples[i], 0.0F) << i - gate;
  }
  const std::size_t before = gate - 480;  // 10 ms: before the fall
  for (std::size_t i = 0; i < before; i += 53) {
    ASSERT_EQ(gated->sound.samples[i], whole->sound.samples[i]) << i;
  }
}

TEST_F(EnactmentTest, NeighboursInTheMarginsOfAWordAreSilent) {
  make_corpus();
  auto& item = corpora_.at("made").items[0];
  item.clear = SpeechInterval{item.start + 200ms, item.end - 150ms};
  Repertoire repertoire{Hertz{48'000}, corpora_};
  const auto& samples = repertoire.perform("corpus:made", "ba", {}).sound.samples;
  const std::size_t from = 48 * 200;
  const std::size_t to = samples.size() - 48 * 150;
  const auto loudest = [&](std::size_t first, std::size_t last) {
    float peak = 0.0F;
    for (std::size_t i = first; i < last; ++i) peak = std::max(peak, std::abs(samples[i]));
    return peak;
  };
  EXPECT_EQ(loudest(0, from), 0.0F);
  EXPECT_EQ(loudest(to + 1, samples.size()), 0.0F);
  EXPECT_GT(loudest(from, to), 0.01F);
}

TEST_F(EnactmentTest, AWordThatIsCutOutOfSpeechFallsFor5Milliseconds) {
  make_corpus();
  Repertoire whole{Hertz{48'000}, corpora_};
  const auto uncut = whole.perform("corpus:made", "ba", {}).sound.samples;
  auto& item = corpora_.at("made").items[0];
  const auto vowel = item.phones.back();
  item.clear = SpeechInterval{vowel.start + 20ms, vowel.end() - 20ms};  // within the vowel
  const auto first = static_cast<std::size_t>(
      nearest_sample(item.clear->start - item.start, Hertz{48'000}).count());
  Repertoire repertoire{Hertz{48'000}, corpora_};
  const auto& cut = repertoire.perform("corpus:made", "ba", {}).sound.samples;
  const auto energy = [](const std::vector<float>& samples, std::size_t from, std::size_t to) {
    double sum = 0;
    for (std::size_t i = from; i < to; ++i) sum += std::pow(static_cast<double>(samples[i]), 2);
    return sum;
  };
  const std::size_t fall = 240;  // 5 ms
  EXPECT_LT(energy(cut, first, first + fall / 3), 0.1 * energy(uncut, first, first + fall / 3));
  for (std::size_t i = first + fall; i < first + 2 * fall; ++i) ASSERT_EQ(cut[i], uncut[i]);
}

TEST_F(EnactmentTest, AWordThatNobodySaysIsNamed) {
  make_corpus();
  Repertoire repertoire{Hertz{48'000}, corpora_};
  const Word ga{.spelling = "ga", .phones = {Phone::G, Phone::AA}, .seen = std::nullopt};
  EXPECT_THAT(made_media::message_of(
                  [&] { static_cast<void>(enact(both("corpus:made", "face"), ga, repertoire)); }),
              HasSubstr("has no item without doubt for \"ga\""));
}

Word bw(int step) {
  const std::vector<Segment> segments{{Phone::B, Phone::W, step, 8}, Phone::AA};
  auto [phones, articulation] = spelled(segments);
  return {.spelling = "bw",
          .phones = std::move(phones),
          .seen = std::nullopt,
          .articulation = std::move(articulation)};
}

protocols::Condition seen_only() {
  protocols::Condition condition;
  condition.name = "seen";
  condition.visual_talker = "face";
  return condition;
}

TEST_F(EnactmentTest, AnAmbiguousWordThatIsOnlySeenLastsBetweenItsEnds) {
  Repertoire repertoire{Hertz{48'000}, none_};
  const auto& ba = repertoire.perform("festival:kal", "bw", {Phone::B, Phone::AA});
  const auto& wa = repertoire.perform("festival:kal", "bw", {Phone::W, Phone::AA});
  const auto first = enact(seen_only(), bw(0), repertoire);
  const auto last = enact(seen_only(), bw(8), repertoire);
  EXPECT_EQ(first.seen, ba.utterance);
  EXPECT_EQ(last.seen, wa.utterance);
  EXPECT_NE(first.length, last.length);
  for (int step = 0; step <= 8; ++step) {
    const auto enactment = enact(seen_only(), bw(step), repertoire);
    const double expected =
        std::lerp(milliseconds(ba.length()), milliseconds(wa.length()), step / 8.0);
    EXPECT_NEAR(milliseconds(enactment.length), expected, 0.001) << step;
    ASSERT_EQ(enactment.articulation.size(), 4U);
    EXPECT_EQ(enactment.articulation[1].segment, (Segment{Phone::B, Phone::W, step, 8}));
    EXPECT_EQ(enactment.sound, nullptr);
  }
}

TEST_F(EnactmentTest, AVoiceSaysTheNearerSoundAndTimesTheFace) {
  Repertoire repertoire{Hertz{48'000}, none_};
  const auto enactment = enact(both("festival:kal", "face"), bw(7), repertoire);
  EXPECT_EQ(enactment.heard,
            repertoire.perform("festival:kal", "bw", {Phone::W, Phone::AA}).utterance);
  EXPECT_EQ(enactment.seen, enactment.heard);
  EXPECT_FALSE(enactment.release);
  EXPECT_EQ(enactment.articulation.at(1).segment, (Segment{Phone::B, Phone::W, 7, 8}));
}

TEST_F(EnactmentTest, AnAmbiguousWordMeetsTheHeardOneAtItsReleaseBetweenThoseOfItsEnds) {
  Repertoire repertoire{Hertz{48'000}, none_};
  const auto release = [&](Phone consonant) {
    const auto& spoken = repertoire.perform("festival:kal", "bw", {consonant, Phone::AA});
    return milliseconds(release_of(spoken.sound, spoken.utterance));
  };
  for (int step = 0; step <= 8; ++step) {
    auto word = kBa;
    word.seen = SeenWord{"bw", bw(step).phones, bw(step).articulation};
    const auto enactment = enact(both("festival:kal", "face"), word, repertoire);
    ASSERT_TRUE(enactment.release);
    const double expected = std::lerp(release(Phone::B), release(Phone::W), step / 8.0);
    EXPECT_NEAR(milliseconds(*enactment.release - enactment.picture_start), expected, 0.001)
        << step;
    EXPECT_EQ(enactment.articulation.at(1).segment, (Segment{Phone::B, Phone::W, step, 8}));
  }
}

TEST_F(EnactmentTest, ReversedTheSegmentsComeFromTheEnd) {
  Repertoire repertoire{Hertz{48'000}, none_};
  auto condition = seen_only();
  condition.manner.reversed = true;
  const auto enactment = enact(condition, bw(3), repertoire);
  EXPECT_EQ(enactment.articulation.at(1).segment, Segment{Phone::AA});
  EXPECT_EQ(enactment.articulation.at(2).segment, (Segment{Phone::B, Phone::W, 3, 8}));
}

TEST_F(EnactmentTest, ARecordingTimesAmbiguousSegmentsOnlyOfItsOwnNumber) {
  make_corpus();
  Repertoire repertoire{Hertz{48'000}, corpora_};
  auto word = bw(3);
  word.spelling = "ba";
  const auto enactment = enact(both("corpus:made", "face"), word, repertoire);
  const auto is_ambiguous = [](const TimedSegment& timed) { return timed.segment.is_ambiguous(); };
  EXPECT_EQ(std::ranges::count_if(enactment.articulation, is_ambiguous), 1);
  word.articulation.push_back(Phone::D);
  EXPECT_THROW(static_cast<void>(enact(both("corpus:made", "face"), word, repertoire)), Error);
}

}  // namespace
}  // namespace bimodal::runner

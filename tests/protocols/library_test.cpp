#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "protocols/design/plan.hpp"
#include "protocols/reading/read_protocol.hpp"
#include "stimuli/base/asset.hpp"
#include "tests/support/face_terms.hpp"

namespace bimodal::protocols {
namespace {

/// As without a corpus: the synthetic voice speaks, the natural face is left out.
ReadOptions without_natural_face() {
  return {.cast = {.without = {"V_nat"}}};
}

bool tells_of_a_stand_in(const Diagnostic& diagnostic) {
  return diagnostic.severity == Severity::Warning &&
         diagnostic.finding.find("takes its place") != std::string::npos;
}

TEST(Library, HasNothingToComplainOfButTheMissingCorpus) {
  std::size_t protocols = 0;
  for (const auto& entry : std::filesystem::directory_iterator{asset("protocols/library")}) {
    if (entry.path().extension() != ".json") continue;
    ++protocols;
    const bool needs_corpus = entry.path().filename().string().starts_with("words4");
    auto options = needs_corpus ? without_natural_face() : ReadOptions{};
    options.face = known_face_terms();
    for (const auto& diagnostic : read_protocol(entry.path(), options).diagnostics) {
      if (!tells_of_a_stand_in(diagnostic)) ADD_FAILURE() << describe(diagnostic);
    }
  }
  EXPECT_GE(protocols, 3U);
}

// Cohen & Massaro (1993), section 5: 414 words, auditory at -8 dB, visual, and both; the natural
// face as control.
TEST(Words414, IsTheExperimentOfSectionFive) {
  const auto read = read_protocol(asset("protocols/library/words414.json"), without_natural_face());
  EXPECT_EQ(read.words.words.size(), 414U);
  EXPECT_EQ(read.practice.size(), 12U);
  ASSERT_EQ(read.protocol.conditions.size(), 3U);
  const auto& auditory = read.protocol.conditions[0];
  const auto& visual = read.protocol.conditions[1];
  const auto& bimodal = read.protocol.conditions[2];
  EXPECT_TRUE(auditory.auditory_talker && !auditory.visual_talker);
  EXPECT_TRUE(!visual.auditory_talker && visual.visual_talker);
  EXPECT_TRUE(bimodal.auditory_talker && bimodal.visual_talker);
  EXPECT_EQ(auditory.snr, Decibels{-8});
  EXPECT_EQ(visual.snr, std::nullopt);
  EXPECT_EQ(bimodal.snr, Decibels{-8});
}

TEST(Words414, WithoutACorpusTheSyntheticVoiceStandsInAndTheNaturalFaceIsMissed) {
  const auto file = asset("protocols/library/words414.json");
  const auto whole = read_protocol(file);
  ASSERT_TRUE(has_errors(whole.diagnostics));
  for (const auto& diagnostic : whole.diagnostics) {
    if (diagnostic.severity != Severity::Error) continue;
    EXPECT_EQ(diagnostic.pointer, "/conditions/3/visual/talker");
    EXPECT_NE(diagnostic.remedy.find("--without V_nat"), std::string::npos);
  }
  for (const auto& condition : read_protocol(file, without_natural_face()).protocol.conditions) {
    EXPECT_EQ(condition.timing_talker, "festival:kal");
  }
}

TEST(Words420, PresentsWordsOfItsOwnAtThreeTimesTheirSpeed) {
  const auto read =
      read_protocol(asset("protocols/library/words420-compressed.json"), without_natural_face());
  EXPECT_EQ(read.words.words.size(), 420U);
  ASSERT_EQ(read.protocol.conditions.size(), 3U);
  for (const auto& condition : read.protocol.conditions) {
    EXPECT_EQ(condition.manner.rate, 3.0);
    EXPECT_EQ(condition.snr, std::nullopt);
  }
}

TEST(Cast, ConditionsThatDoNotExistCannotBeLeftOut) {
  const auto read = read_protocol(asset("protocols/library/first-steps.json"),
                                  {.cast = {.without = {"bimodl"}, .with = {}}});
  ASSERT_TRUE(has_errors(read.diagnostics));
  EXPECT_NE(describe(read.diagnostics[0]).find("\"bimodl\""), std::string::npos);
}

TEST(Words414, GivesEachParticipant138WordsPerConditionInSixBlocks) {
  const auto read = read_protocol(asset("protocols/library/words414.json"), without_natural_face());
  for (int participant = 1; participant <= 6; ++participant) {
    const auto plan = make_plan(read.protocol, read.words, read.practice, {participant, 1});
    ASSERT_EQ(plan.size(), 426U);
    std::map<std::size_t, int> per_condition;
    std::map<int, int> per_block;
    std::set<std::string> words;
    for (const auto& trial : plan) {
      words.insert(trial.word.spelling);
      ++per_block[trial.block];
      if (trial.phase == Phase::Main) ++per_condition[trial.condition];
    }
    EXPECT_EQ(words.size(), 426U);
    EXPECT_EQ(per_block,
              (std::map<int, int>{{0, 12}, {1, 69}, {2, 69}, {3, 69}, {4, 69}, {5, 69}, {6, 69}}));
    EXPECT_EQ(per_condition, (std::map<std::size_t, int>{{0, 138}, {1, 138}, {2, 138}}));
  }
}

TEST(BaWa, DubsNineStepsOntoTwoSyllables) {
  const auto read = read_protocol(asset("protocols/library/ba-wa.json"), {});
  EXPECT_TRUE(read.diagnostics.empty());
  ASSERT_EQ(read.words.words.size(), 18U);
  for (std::size_t i = 0; i < 18; ++i) {
    const auto& word = read.words.words[i];
    const Phone heard = i < 9 ? Phone::B : Phone::W;
    EXPECT_EQ(word.phones, (Pronunciation{heard, Phone::AA}));
    ASSERT_TRUE(word.seen);
    EXPECT_EQ(word.seen->articulation.at(0),
              (Segment{Phone::B, Phone::W, static_cast<int>(i % 9), 8}));
  }
}

TEST(BaWa, AsksForOneOfTwoKeysAndTimesThemFromTheSound) {
  const auto response = read_protocol(asset("protocols/library/ba-wa.json"), {}).protocol.response;
  EXPECT_EQ(response.kind, ResponseKind::Choice);
  EXPECT_EQ(response.rt_from, RtFrom::SoundOnset);
  EXPECT_EQ(response.options, (std::vector<Option>{{"ba", "f", 0}, {"wa", "j", 0}}));
}

// Without sound, so that nothing but what is seen can make the difference.
TEST(SeenParts, ShowsTheSameWordsWholeByTheLipsAndWithoutTheTongue) {
  const auto read =
      read_protocol(asset("protocols/library/seen-parts.json"), {.face = known_face_terms()});
  EXPECT_EQ(read.words.words.size() % 3, 0U);
  const auto& conditions = read.protocol.conditions;
  ASSERT_EQ(conditions.size(), 3U);
  for (const auto& condition : conditions) {
    EXPECT_FALSE(condition.auditory_talker);
    EXPECT_EQ(condition.timing_talker, conditions.front().timing_talker);
  }
  EXPECT_EQ(conditions[0].face, Face{});
  EXPECT_EQ(conditions[1].face.show, std::vector<std::string>{"lips"});
  EXPECT_EQ(conditions[2].face.hide, std::vector<std::string>{"tongue"});
}

}  // namespace
}  // namespace bimodal::protocols

#include "stimuli/labels/labels.hpp"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/labels/label_file.hpp"
#include "tests/stimuli/labels/label_cases.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;
using label_cases::message_of;
using ::testing::AllOf;
using ::testing::HasSubstr;
using enum Phone;

/// Labels of 100 ms each, from 0.
Tier tier_of(const std::vector<std::string>& texts) {
  Tier tier{.name = "phones", .labels = {}};
  for (const auto& text : texts) {
    const Duration start = tier.labels.empty() ? 0ms : tier.labels.back().end;
    tier.labels.push_back({start, start + 100ms, text});
  }
  return tier;
}

std::vector<TimedPhone> phones_of(const std::vector<std::string>& texts) {
  const auto tier = tier_of(texts);
  return utterance_of(tier, tier.labels.back().end).phones;
}

using Phones = std::vector<TimedPhone>;

TEST(Labels, FindTheirPhonesAndWordsByName) {
  Labels labels;
  EXPECT_EQ(phone_tier(labels), nullptr);
  for (const auto* const name : {"Speaker", "WORDS", "Segment", "phones"}) {
    labels.tiers.push_back({.name = name, .labels = {}});
  }
  EXPECT_EQ(phone_tier(labels), &labels.tiers[2]);
  EXPECT_EQ(word_tier(labels), &labels.tiers[1]);
}

TEST(Labels, KnowSilence) {
  for (const auto* const text :
       {"", "sil", "SP", "pau", "Rest", "#", "h#", "H#", "<SIL>", "<p:>", "_", "..."}) {
    EXPECT_TRUE(is_silence(text)) << text;
  }
  for (const auto* const text : {"s", "silence", "p", "spn", "-"}) {
    EXPECT_FALSE(is_silence(text)) << text;
  }
}

TEST(UtteranceOf, FillsGapsWithRestAndJoinsRests) {
  const Tier tier{.name = "phones",
                  .labels = {{100ms, 200ms, "sil"},
                             {200ms, 300ms, "K"},
                             {300ms, 400ms, "ae1"},
                             {450ms, 500ms, "t"},
                             {500ms, 550ms, ""},
                             {550ms, 600ms, "sp"}}};
  EXPECT_EQ(utterance_of(tier, 1s).phones,
            (Phones{{Rest, 0ms, 200ms},
                    {K, 200ms, 100ms},
                    {AE, 300ms, 100ms},
                    {Rest, 400ms, 50ms},
                    {T, 450ms, 50ms},
                    {Rest, 500ms, 500ms}}));
}

TEST(UtteranceOf, ClosesGapsOfRounding) {
  const Tier tier{
      .name = "phones",
      .labels = {{1us, 100ms, "K"}, {100'001us, 200ms, "AE"}, {199'999'500ns, 300ms, "T"}}};
  EXPECT_EQ(utterance_of(tier, 300'001us).phones,
            (Phones{{K, 0ms, 100ms}, {AE, 100ms, 100ms}, {T, 200ms, 100'001us}}));
}

TEST(UtteranceOf, OfNothingIsRest) {
  EXPECT_EQ(utterance_of({.name = "phones", .labels = {}}, 1s).phones, (Phones{{Rest, 0s, 1s}}));
  EXPECT_TRUE(utterance_of({.name = "phones", .labels = {}}, 0s).phones.empty());
}

TEST(UtteranceOf, KnowsEveryPhoneInAnyCaseWithAnyStress) {
  for (const Phone phone : all_phones()) {
    std::string name{symbol(phone)};
    EXPECT_EQ(phones_of({name}), (Phones{{phone, 0ms, 100ms}}));
    std::ranges::transform(
        name, name.begin(), [](char c) { return static_cast<char>(std::tolower(c)); });
    EXPECT_EQ(phones_of({name}), (Phones{{phone, 0ms, 100ms}}));
    if (is_vowel(phone)) {
      EXPECT_EQ(phones_of({name + "1"}), (Phones{{phone, 0ms, 100ms}}));
    }
  }
}

TEST(UtteranceOf, KnowsTheNamesOfFestivalAndTimit) {
  const std::vector<std::pair<std::string, Phone>> names{{"axr", ER},
                                                         {"AXR0", ER},
                                                         {"hv", HH},
                                                         {"dx", D},
                                                         {"nx", N},
                                                         {"ux", UW},
                                                         {"ix", IH},
                                                         {"ax-h", AX},
                                                         {"eng", NG},
                                                         {"pau", Rest},
                                                         {"h#", Rest},
                                                         {"epi", Rest},
                                                         {"brth", Rest}};
  for (const auto& [name, phone] : names) {
    EXPECT_EQ(phones_of({name}), (Phones{{phone, 0ms, 100ms}})) << name;
  }
}

TEST(UtteranceOf, HalvesSyllabicConsonants) {
  EXPECT_EQ(phones_of({"b", "el", "EM"}),
            (Phones{{B, 0ms, 100ms},
                    {AX, 100ms, 50ms},
                    {L, 150ms, 50ms},
                    {AX, 200ms, 50ms},
                    {M, 250ms, 50ms}}));
}

TEST(UtteranceOf, JoinsAClosureWithItsRelease) {
  EXPECT_EQ(phones_of({"h#", "bcl", "b", "iy", "tcl", "ch", "dcl", "jh", "kcl", "g", "h#"}),
            (Phones{{Rest, 0ms, 100ms},
                    {B, 100ms, 200ms},
                    {IY, 300ms, 100ms},
                    {CH, 400ms, 200ms},
                    {JH, 600ms, 200ms},
                    {G, 800ms, 200ms},
                    {Rest, 1000ms, 100ms}}));
}

TEST(UtteranceOf, TakesAClosureWithoutReleaseForTheStop) {
  EXPECT_EQ(phones_of({"ae", "kcl", "tcl", "t", "pcl"}),
            (Phones{{AE, 0ms, 100ms}, {K, 100ms, 100ms}, {T, 200ms, 200ms}, {P, 400ms, 100ms}}));
  EXPECT_EQ(phones_of({"gcl", "d", "tcl", "s"}),
            (Phones{{G, 0ms, 100ms}, {D, 100ms, 100ms}, {T, 200ms, 100ms}, {S, 300ms, 100ms}}));
  const Tier apart{.name = "phones", .labels = {{0ms, 100ms, "tcl"}, {200ms, 300ms, "t"}}};
  EXPECT_EQ(utterance_of(apart, 300ms).phones,
            (Phones{{T, 0ms, 100ms}, {Rest, 100ms, 100ms}, {T, 200ms, 100ms}}));
}

TEST(UtteranceOf, GivesTheTimeOfAGlottalStopToItsNeighbour) {
  EXPECT_EQ(phones_of({"h#", "q", "ae", "q", "h#", "q", "h#"}),
            (Phones{{Rest, 0ms, 100ms}, {AE, 100ms, 300ms}, {Rest, 400ms, 300ms}}));
  EXPECT_EQ(phones_of({"q", "tcl", "t", "q"}), (Phones{{T, 0ms, 400ms}}));
  EXPECT_EQ(phones_of({"q"}), (Phones{{Rest, 0ms, 100ms}}));
}

TEST(UtteranceOf, NamesTheLabelThatIsNoPhone) {
  EXPECT_THAT(message_of([] {
                (void)utterance_of(tier_of({"K", "\xC3\xA6"}), 200ms);
              }),
              AllOf(HasSubstr("tier \"phones\": the label \"\xC3\xA6\" at 0.1 s is no phone"),
                    HasSubstr("write one of P B M"),
                    HasSubstr("\"sil\"")));
  EXPECT_EQ(not_phones(tier_of({"K", "x", "bcl", "", "cat"})),
            (std::vector<Label>{{100ms, 200ms, "x"}, {400ms, 500ms, "cat"}}));
}

TEST(UtteranceOf, RefusesTimesThatMakeNoUtterance) {
  EXPECT_THAT(message_of([] {
                (void)utterance_of(tier_of({"K", "AE"}), 150ms);
              }),
              HasSubstr("the label \"AE\" at 0.1 s is not between"));
  const Tier point{.name = "phones", .labels = {{100ms, 100ms, "K"}}};
  EXPECT_THAT(message_of([&] { (void)utterance_of(point, 1s); }), HasSubstr("is a point"));
  const Tier silent{.name = "phones", .labels = {{100ms, 100ms, "sil"}}};
  EXPECT_EQ(utterance_of(silent, 1s).phones, (Phones{{Rest, 0s, 1s}}));
}

TEST(LabelsOf, GiveTheUtteranceBack) {
  Random random{9};
  for (int i = 0; i < 200; ++i) {
    Utterance utterance;
    for (std::size_t k = 0; k < 1 + random.below(10); ++k) {
      const auto phone = all_phones()[random.below(kPhoneCount)];
      const bool after_rest = !utterance.phones.empty() && utterance.phones.back().phone == Rest;
      if (phone == Rest && after_rest) continue;
      const Duration length{static_cast<Duration::rep>(1'000 + random.below(1'000'000'000))};
      utterance.phones.push_back({phone, utterance.end(), length});
    }
    const auto labels = labels_of(utterance, {{0ns, 500ns, "word"}});
    ASSERT_EQ(utterance_of(*phone_tier(labels), labels.end), utterance);
    ASSERT_EQ(word_tier(labels)->labels.size(), 1U);
    ASSERT_EQ(labels_of(utterance).tiers.size(), 1U);
  }
}

TEST(LabelsOf, LeaveOutRestsOfNoLength) {
  const Utterance utterance{{{Rest, 0ms, 0ms}, {AE, 0ms, 100ms}, {Rest, 100ms, 0ms}}};
  EXPECT_EQ(labels_of(utterance),
            (Labels{.end = 100ms, .tiers = {{.name = "phones", .labels = {{0ms, 100ms, "AE"}}}}}));
}

TEST(UtteranceOf, ReadsTheAlignedClips) {
  const char* const folder = std::getenv("BIMODAL_TEST_DATA");
  if (folder == nullptr) GTEST_SKIP() << "BIMODAL_TEST_DATA is not set";
  const auto clips = std::filesystem::path{folder} / "lips";
  if (!std::filesystem::exists(clips)) GTEST_SKIP() << clips << " is not there";
  std::size_t read = 0;
  for (const auto& entry : std::filesystem::directory_iterator{clips}) {
    if (entry.path().extension() != ".TextGrid") continue;
    const auto labels = read_labels(entry.path());
    ASSERT_NE(phone_tier(labels), nullptr) << entry.path();
    const auto utterance = utterance_of(*phone_tier(labels), labels.end);
    EXPECT_EQ(utterance.end(), labels.end);
    EXPECT_EQ(utterance.phones.front().phone, Rest);
    EXPECT_EQ(word_tier(labels)->labels.size(), 6U);  // a sentence of GRID
    ++read;
  }
  EXPECT_GT(read, 0U);
}

}  // namespace
}  // namespace bimodal

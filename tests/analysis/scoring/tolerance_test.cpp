#include "analysis/scoring/tolerance.hpp"

#include <gtest/gtest.h>

#include "analysis/scoring/spelling.hpp"

namespace bimodal::analysis {
namespace {

struct Example {
  std::string word;
  std::string answer;
  std::optional<Tolerance> by;  ///< what takes it where all rules are on
};

ScoringRules all_rules() {
  ScoringRules rules;
  for (const Tolerance tolerance : kTolerances) rules.tolerate(tolerance);
  return rules;
}

constexpr std::optional<Tolerance> kNone = std::nullopt;

class ToleratedAnswers : public testing::TestWithParam<Example> {};

TEST_P(ToleratedAnswers, AreTakenByTheRuleBothWaysRoundAndByNoOther) {
  const auto& [word, answer, by] = GetParam();
  const auto one = fold_spelling(word);
  const auto other = fold_spelling(answer);
  EXPECT_EQ(tolerated(one, other, false, all_rules()), by);
  EXPECT_EQ(tolerated(other, one, false, all_rules()), by);
  EXPECT_EQ(tolerated(one, other, false, {}), kNone);
  if (!by) return;
  ScoringRules alone;
  alone.tolerate(*by);
  EXPECT_EQ(tolerated(one, other, false, alone), by);
  auto others = all_rules();
  others.tolerated.at(static_cast<std::size_t>(*by)) = false;
  EXPECT_EQ(tolerated(one, other, false, others), kNone);
}

INSTANTIATE_TEST_SUITE_P(ByHand,
                         ToleratedAnswers,
                         testing::Values(Example{"stuff", "stuf", Tolerance::DoubleLetters},
                                         Example{"spelling", "speling", Tolerance::DoubleLetters},
                                         Example{"comittee", "committee", Tolerance::DoubleLetters},
                                         Example{"cat", "cats", Tolerance::Plural},
                                         Example{"fox", "foxes", Tolerance::Plural},
                                         Example{"church", "churches", Tolerance::Plural},
                                         Example{"potato", "potatoes", Tolerance::Plural},
                                         Example{"piano", "pianos", Tolerance::Plural},
                                         Example{"city", "cities", Tolerance::Plural},
                                         Example{"boy", "boys", Tolerance::Plural},
                                         Example{"city", "citys", kNone},
                                         Example{"walk", "walked", Tolerance::Tense},
                                         Example{"walking", "walked", Tolerance::Tense},
                                         Example{"bake", "baked", Tolerance::Tense},
                                         Example{"bake", "baking", Tolerance::Tense},
                                         Example{"stop", "stopped", Tolerance::Tense},
                                         Example{"stopping", "stop", Tolerance::Tense},
                                         Example{"try", "tried", Tolerance::Tense},
                                         Example{"tried", "trying", Tolerance::Tense},
                                         Example{"tie", "tying", Tolerance::Tense},
                                         Example{"play", "played", Tolerance::Tense},
                                         Example{"go", "went", Tolerance::Tense},
                                         Example{"gone", "going", Tolerance::Tense},
                                         Example{"sing", "sang", Tolerance::Tense},
                                         Example{"swim", "swimming", Tolerance::Tense},
                                         Example{"make", "making", Tolerance::Tense},
                                         Example{"see", "seeing", Tolerance::Tense},
                                         Example{"is", "being", Tolerance::Tense},
                                         Example{"see", "seed", kNone},
                                         Example{"she", "shed", kNone},
                                         Example{"the", "thing", kNone},
                                         Example{"be", "bed", kNone},
                                         Example{"red", "ring", kNone},
                                         Example{"lied", "lay", kNone},
                                         Example{"can't", "can not", Tolerance::Contractions},
                                         Example{"we'll", "we will", Tolerance::Contractions},
                                         Example{"won't", "will not", Tolerance::Contractions},
                                         Example{"he's", "he has", Tolerance::Contractions},
                                         Example{"well", "we will", kNone},
                                         Example{"two", "2", Tolerance::Numbers},
                                         Example{"twenty-two", "22", Tolerance::Numbers},
                                         Example{"one thousand", "1,000", Tolerance::Numbers},
                                         Example{"two", "3", kNone},
                                         Example{"cat", "dog", kNone}));

TEST(Tolerated, TakesNoOtherWordForDoubledLetters) {
  const auto rules = all_rules();
  EXPECT_EQ(tolerated("good", "god", false, rules), Tolerance::DoubleLetters);
  EXPECT_EQ(tolerated("good", "god", true, rules), kNone);
  EXPECT_EQ(tolerated("cat", "cats", true, rules), Tolerance::Plural);
}

TEST(ToleranceName, IsReadBack) {
  for (const Tolerance tolerance : kTolerances) {
    EXPECT_EQ(tolerance_from_name(name(tolerance)), tolerance);
  }
  EXPECT_EQ(tolerance_from_name("everything"), kNone);
}

TEST(DescribeRules, SaysWhatIsNotAsUsual) {
  EXPECT_NE(describe_rules({}).find("Tolerated: nothing"), std::string::npos);
  ScoringRules rules;
  rules.tolerate(Tolerance::Plural);
  rules.tolerate(Tolerance::Tense);
  EXPECT_NE(describe_rules(rules).find("Tolerated: plural, tense"), std::string::npos);
}

}  // namespace
}  // namespace bimodal::analysis

#include "analysis/scoring/lexical_equivalence.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "analysis/scoring/lexicon.hpp"

namespace bimodal::analysis {
namespace {

// By hand: bat, pat and mat look the same, red and read are said the same, see is alone.
TEST(LexicalEquivalence, CountsWordsThatLookTheSame) {
  const auto dictionary = parse_lexicon(
      "word,phonemes\nbat,B AE T\npat,P AE T\nmat,M AE T\nred,R EH D\nread,R EH D\nsee,S IY\n",
      "l.csv");
  const auto found = lexical_equivalence(dictionary, {{"p", "b", "m"}, {"f", "v"}, {"blank"}});
  EXPECT_EQ(found.words, 6U);
  EXPECT_EQ(found.classes, 3U);
  EXPECT_EQ(found.unique, 1U);
  EXPECT_EQ(found.unique_by_sound, 4U);
  EXPECT_DOUBLE_EQ(found.unique_share, 1.0 / 6.0);
  EXPECT_DOUBLE_EQ(found.expected_size, (9.0 + 4.0 + 1.0) / 6.0);
  const double entropy = std::log2(6.0) - (3.0 * std::log2(3.0) + 2.0) / 6.0;
  EXPECT_NEAR(found.extracted, entropy / std::log2(6.0), 1e-12);
}

TEST(LexicalEquivalence, LosesNothingWhereEveryPhoneIsAlone) {
  const auto dictionary = parse_lexicon("word,phonemes\nbat,B AE T\npat,P AE T\n", "l.csv");
  const auto found = lexical_equivalence(dictionary, {});
  EXPECT_EQ(found.unique, 2U);
  EXPECT_DOUBLE_EQ(found.extracted, 1.0);
  EXPECT_DOUBLE_EQ(found.expected_size, 1.0);
}

}  // namespace
}  // namespace bimodal::analysis

#include "analysis/scoring/alignment.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "stimuli/base/random.hpp"
#include "tests/analysis/examples.hpp"

namespace bimodal::analysis {
namespace {

using examples::phones;

const Partner kNothing = std::nullopt;

/// Every alignment there is, one by one: an independent way to the same answer.
struct Enumeration {
  std::pair<int, int> best{1 << 20, 0};  ///< cost, minus matches
  std::vector<std::set<Partner>> partners;
};

Enumeration enumerate(const Pronunciation& stimulus, const Pronunciation& answer) {
  Enumeration result;
  std::vector<Partner> chosen;
  const std::function<void(std::size_t, int, int)> go = [&](std::size_t j, int cost, int matches) {
    const std::size_t i = chosen.size();
    if (i == stimulus.size()) {
      cost += static_cast<int>(answer.size() - j);  // what is left was inserted
      const std::pair rank{cost, -matches};
      if (rank > result.best) return;
      if (rank < result.best || result.partners.empty()) {
        result.best = rank;
        result.partners.assign(stimulus.size(), {});
      }
      for (std::size_t k = 0; k < stimulus.size(); ++k) result.partners[k].insert(chosen[k]);
      return;
    }
    chosen.push_back(std::nullopt);
    go(j, cost + 1, matches);
    chosen.pop_back();
    for (std::size_t k = j; k < answer.size(); ++k) {
      if (is_vowel(stimulus[i]) != is_vowel(answer[k])) continue;
      const bool same = stimulus[i] == answer[k];
      chosen.push_back(answer[k]);
      go(k + 1, cost + static_cast<int>(k - j) + (same ? 0 : 1), matches + (same ? 1 : 0));
      chosen.pop_back();
    }
  };
  go(0, 0, 0);
  return result;
}

TEST(Align, FindsSubstitutionsDeletionsAndInsertions) {
  const auto found = align(phones("S T UW"), phones("T IY Z"));
  EXPECT_EQ(found.cost, 3);
  EXPECT_EQ(found.matches, 1);
  EXPECT_EQ(found.partners,
            (std::vector<std::vector<Partner>>{{kNothing}, {Phone::T}, {Phone::IY}}));
}

TEST(Align, NeverSetsAVowelAgainstAConsonant) {
  const auto found = align(phones("IY"), phones("B"));
  EXPECT_EQ(found.cost, 2);
  EXPECT_EQ(found.partners, (std::vector<std::vector<Partner>>{{kNothing}}));
}

TEST(Align, AmongEqualCostsPrefersMatches) {
  // P L OW against L P OW: two substitutions cost 2, and so do a deletion and an insertion, which
  // leave one consonant right; which one, the answer does not tell.
  const auto found = align(phones("P L OW"), phones("L P OW"));
  EXPECT_EQ(found.cost, 2);
  EXPECT_EQ(found.matches, 2);
  EXPECT_EQ(
      found.partners,
      (std::vector<std::vector<Partner>>{{kNothing, Phone::P}, {kNothing, Phone::L}, {Phone::OW}}));
}

TEST(Align, TellsWhichPlacesAreAmbiguous) {
  const auto found = align(phones("S T UW"), phones("P UW"));  // S or T became P
  EXPECT_EQ(
      found.partners,
      (std::vector<std::vector<Partner>>{{kNothing, Phone::P}, {kNothing, Phone::P}, {Phone::UW}}));
}

TEST(Align, OfAnEmptyAnswerIsAllDeletions) {
  const auto found = align(phones("S T UW"), {});
  EXPECT_EQ(found.cost, 3);
  EXPECT_EQ(found.partners, (std::vector<std::vector<Partner>>(3, {kNothing})));
}

TEST(AlignWithAny, TakesThePronunciationOfLeastCost) {
  const std::vector answers{phones("R EH D"), phones("R IY D")};
  const auto found = align_with_any(phones("L IY D"), answers);
  EXPECT_EQ(found.cost, 1);
  EXPECT_EQ(found.partners[1], std::vector<Partner>{Phone::IY});
}

TEST(AlignWithAny, KeepsBothOfTwoEqualPronunciations) {
  const std::vector answers{phones("R EH D"), phones("R IY D")};
  const auto found = align_with_any(phones("R IH D"), answers);
  EXPECT_EQ(found.partners,
            (std::vector<std::vector<Partner>>{{Phone::R}, {Phone::IY, Phone::EH}, {Phone::D}}));
}

TEST(Align, AgreesWithTheEnumerationOfAllAlignments) {
  Random random{20261122};
  const Pronunciation alphabet = phones("P T S L IY AH");
  const auto draw = [&] {
    Pronunciation drawn(random.below(6));
    for (auto& phone : drawn) phone = alphabet[random.below(alphabet.size())];
    return drawn;
  };
  int ambiguous = 0;
  for (int round = 0; round < 3000; ++round) {
    const auto stimulus = draw();
    const auto answer = draw();
    const auto found = align(stimulus, answer);
    const auto expected = enumerate(stimulus, answer);
    SCOPED_TRACE(spell(stimulus) + " / " + spell(answer));
    ASSERT_EQ(found.cost, expected.best.first);
    ASSERT_EQ(found.matches, -expected.best.second);
    ASSERT_EQ(found.partners.size(), stimulus.size());
    for (std::size_t i = 0; i < stimulus.size(); ++i) {
      const std::set<Partner> partners(found.partners[i].begin(), found.partners[i].end());
      ASSERT_EQ(partners, expected.partners[i]);
      ASSERT_EQ(partners.size(), found.partners[i].size());
      if (partners.size() > 1) ++ambiguous;
    }
  }
  EXPECT_GT(ambiguous, 100);  // the property was tried where it matters
}

}  // namespace
}  // namespace bimodal::analysis

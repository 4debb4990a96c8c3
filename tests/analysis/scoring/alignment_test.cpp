#include "analysis/scoring/alignment.hpp"

#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "analysis/scoring/phone_features.hpp"
#include "stimuli/base/random.hpp"
#include "tests/analysis/examples.hpp"

namespace bimodal::analysis {
namespace {

using examples::phones;

const Partner kNothing = std::nullopt;
using Partners = std::vector<std::vector<Partner>>;

/// Without their counts.
Partners partners_of(const Alignment& alignment) {
  Partners partners;
  for (const auto& place : alignment.partners) {
    auto& found = partners.emplace_back();
    for (const auto& one : place) found.push_back(one.partner);
  }
  return partners;
}

/// Every alignment there is, one by one: an independent way to the same answer.
class Enumeration {
 public:
  using Merit = std::tuple<int, int, int>;  ///< cost in fifteenths, minus matches, insertions

  Enumeration(const Pronunciation& stimulus, AlignmentCosts costs)
      : stimulus_{stimulus}, costs_{costs}, counts_(stimulus.size()) {}

  void try_answer(const Pronunciation& answer) {
    chosen_.clear();
    go(answer, 0, {0, 0, 0});
  }

  [[nodiscard]] Merit best() const { return best_; }

  [[nodiscard]] double alignments() const { return alignments_; }

  /// Of a stimulus phone: partners, and in how many of the best alignments.
  [[nodiscard]] const std::map<Partner, double>& counts(std::size_t place) const {
    return counts_[place];
  }

 private:
  void go(const Pronunciation& answer, std::size_t next, Merit merit) {
    auto [cost, minus_matches, insertions] = merit;
    const std::size_t i = chosen_.size();
    if (i == stimulus_.size()) {
      const int rest = static_cast<int>(answer.size() - next);  // inserted
      keep_if_best({cost + 15 * rest, minus_matches, insertions + rest});
      return;
    }
    chosen_.push_back(std::nullopt);
    go(answer, next, {cost + 15, minus_matches, insertions});
    chosen_.pop_back();
    for (std::size_t k = next; k < answer.size(); ++k) {
      if (is_vowel(stimulus_[i]) != is_vowel(answer[k])) continue;
      const bool same = stimulus_[i] == answer[k];
      const int skipped = static_cast<int>(k - next);
      const int differing =
          costs_ == AlignmentCosts::Unit ? 15 : feature_difference(stimulus_[i], answer[k]);
      chosen_.push_back(answer[k]);
      go(answer,
         k + 1,
         {cost + 15 * skipped + (same ? 0 : differing),
          minus_matches - (same ? 1 : 0),
          insertions + skipped});
      chosen_.pop_back();
    }
  }

  void keep_if_best(const Merit& merit) {
    if (merit > best_) return;
    if (merit < best_) {
      best_ = merit;
      alignments_ = 0.0;
      counts_.assign(stimulus_.size(), {});
    }
    alignments_ += 1.0;
    for (std::size_t i = 0; i < chosen_.size(); ++i) counts_[i][chosen_[i]] += 1.0;
  }

  Pronunciation stimulus_;
  AlignmentCosts costs_;
  std::vector<Partner> chosen_;
  Merit best_{1 << 20, 0, 0};
  double alignments_ = 0.0;
  std::vector<std::map<Partner, double>> counts_;
};

void expect_enumerated(const Alignment& found, const Enumeration& expected) {
  const auto [cost, minus_matches, insertions] = expected.best();
  ASSERT_NEAR(found.cost, cost / 15.0, 1e-12);
  ASSERT_EQ(found.matches, -minus_matches);
  ASSERT_EQ(found.insertions, insertions);
  ASSERT_EQ(found.alignments, expected.alignments());
  for (std::size_t i = 0; i < found.partners.size(); ++i) {
    std::map<Partner, double> counts;
    for (const auto& one : found.partners[i]) counts[one.partner] += one.alignments;
    ASSERT_EQ(counts, expected.counts(i));
    ASSERT_EQ(counts.size(), found.partners[i].size());
  }
}

Pronunciation draw(Random& random, const Pronunciation& alphabet) {
  Pronunciation drawn(random.below(6));
  for (auto& phone : drawn) phone = alphabet[random.below(alphabet.size())];
  return drawn;
}

TEST(Align, FindsSubstitutionsDeletionsAndInsertions) {
  const auto found = align(phones("S T UW"), phones("T IY Z"));
  EXPECT_EQ(found.cost, 3);
  EXPECT_EQ(found.matches, 1);
  EXPECT_EQ(partners_of(found), (Partners{{kNothing}, {Phone::T}, {Phone::IY}}));
}

TEST(Align, NeverSetsAVowelAgainstAConsonant) {
  const auto found = align(phones("IY"), phones("B"));
  EXPECT_EQ(found.cost, 2);
  EXPECT_EQ(partners_of(found), (Partners{{kNothing}}));
}

TEST(Align, AmongEqualCostsPrefersMatches) {
  // P L OW against L P OW: two substitutions cost 2, and so do a deletion and an insertion, which
  // leave one consonant right; which one, the answer does not tell.
  const auto found = align(phones("P L OW"), phones("L P OW"));
  EXPECT_EQ(found.cost, 2);
  EXPECT_EQ(found.matches, 2);
  EXPECT_EQ(partners_of(found),
            (Partners{{kNothing, Phone::P}, {kNothing, Phone::L}, {Phone::OW}}));
}

TEST(Align, TellsWhichPlacesAreAmbiguous) {
  const auto found = align(phones("S T UW"), phones("P UW"));  // S or T became P
  EXPECT_EQ(partners_of(found),
            (Partners{{kNothing, Phone::P}, {kNothing, Phone::P}, {Phone::UW}}));
}

TEST(Align, OfAnEmptyAnswerIsAllDeletions) {
  const auto found = align(phones("S T UW"), {});
  EXPECT_EQ(found.cost, 3);
  EXPECT_EQ(partners_of(found), (Partners(3, {kNothing})));
}

TEST(AlignWithAny, TakesThePronunciationOfLeastCost) {
  const std::vector answers{phones("R EH D"), phones("R IY D")};
  const auto found = align_with_any(phones("L IY D"), answers).alignment;
  EXPECT_EQ(found.cost, 1);
  EXPECT_EQ(partners_of(found)[1], std::vector<Partner>{Phone::IY});
}

TEST(AlignWithAny, KeepsBothOfTwoEqualPronunciations) {
  const std::vector answers{phones("R EH D"), phones("R IY D")};
  const auto found = align_with_any(phones("R IH D"), answers).alignment;
  EXPECT_EQ(partners_of(found), (Partners{{Phone::R}, {Phone::IY, Phone::EH}, {Phone::D}}));
}

TEST(Align, CountsEachAlignmentOnceWhateverTheOrderOfItsSteps) {
  // IY against B: deleted and inserted, in either order, it is one alignment.
  EXPECT_EQ(align(phones("IY"), phones("B")).alignments, 1.0);
  // Two phones against one: by hand, S or T is deleted.
  const auto found = align(phones("S T UW"), phones("P UW"));
  EXPECT_EQ(found.alignments, 2.0);
  EXPECT_EQ(found.partners[0], (std::vector<PartnerCount>{{std::nullopt, 1.0}, {Phone::P, 1.0}}));
}

TEST(Align, CountsInsertions) {
  EXPECT_EQ(align(phones("T UW"), phones("S T UW N")).insertions, 2);
  EXPECT_EQ(align(phones("T UW"), phones("T UW")).insertions, 0);
  EXPECT_EQ(align({}, phones("T UW")).insertions, 2);
}

TEST(Align, ByFeaturesPrefersTheLikerPhone) {
  // S or T against D: by unit costs either; by features T, from which D differs in voicing alone.
  const auto found = align(phones("S T UW"), phones("D UW"), AlignmentCosts::Feature);
  EXPECT_EQ(partners_of(found), (Partners{{kNothing}, {Phone::D}, {Phone::UW}}));
  EXPECT_NEAR(found.cost, 1.0 + 1.0 / 3.0, 1e-12);
}

class AlignEnumerated : public testing::TestWithParam<AlignmentCosts> {};

TEST_P(AlignEnumerated, AgreesWithTheEnumerationOfAllAlignments) {
  Random random{20261122};
  const Pronunciation alphabet = phones("P T S L IY AH");
  int ambiguous = 0;
  for (int round = 0; round < 3000; ++round) {
    const auto stimulus = draw(random, alphabet);
    const auto answer = draw(random, alphabet);
    const auto found = align(stimulus, answer, GetParam());
    Enumeration expected{stimulus, GetParam()};
    expected.try_answer(answer);
    SCOPED_TRACE(spell(stimulus) + " / " + spell(answer));
    ASSERT_NO_FATAL_FAILURE(expect_enumerated(found, expected));
    for (const auto& partners : found.partners) ambiguous += partners.size() > 1 ? 1 : 0;
  }
  EXPECT_GT(ambiguous, 100);  // the property was tried where it matters
}

TEST_P(AlignEnumerated, AgreesWithTheEnumerationOverAllPronunciations) {
  Random random{20261123};
  const Pronunciation alphabet = phones("P T L IY AH");
  int shared = 0;
  for (int round = 0; round < 1000; ++round) {
    const auto stimulus = draw(random, alphabet);
    const std::vector answers{
        draw(random, alphabet), draw(random, alphabet), draw(random, alphabet)};
    const auto found = align_with_any(stimulus, answers, GetParam());
    Enumeration expected{stimulus, GetParam()};
    for (const auto& answer : answers) expected.try_answer(answer);
    SCOPED_TRACE(spell(stimulus) + " / " + spell(answers[0]) + " / " + spell(answers[1]) + " / " +
                 spell(answers[2]));
    ASSERT_NO_FATAL_FAILURE(expect_enumerated(found.alignment, expected));
    double alignments = 0.0;
    for (const auto& best : found.best) alignments += best.alignments;
    ASSERT_EQ(alignments, expected.alignments());
    shared += found.best.size() > 1 ? 1 : 0;
  }
  EXPECT_GT(shared, 50);
}

INSTANTIATE_TEST_SUITE_P(Costs,
                         AlignEnumerated,
                         testing::Values(AlignmentCosts::Unit, AlignmentCosts::Feature));

}  // namespace
}  // namespace bimodal::analysis

#include <algorithm>

#include <gmock/gmock.h>

#include "analysis/report/page.hpp"
#include "analysis/report/print/blocks.hpp"
#include "analysis/report/report_figures.hpp"
#include "analysis/report/tables.hpp"
#include "stimuli/base/error.hpp"
#include "tests/analysis/report/planned_study.hpp"

namespace bimodal::analysis {
namespace {

using examples::five_conditions;
using examples::kParticipants;
using examples::results_of;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

Results compared(const std::string& natural = "AV natural",
                 const std::string& synthetic = "AV synthetic") {
  return results_of(five_conditions(),
                    kParticipants,
                    {.bootstrap = {.draws = 200, .seed = 1},
                     .faces = FaceConditions{natural, synthetic},
                     .comparison = {.permutations = 200, .splits = 20, .seed = 1}});
}

const Making kMaking{.program = "bimodal-analysis 0.1.0",
                     .made_utc = "2026-11-22T10:00:00Z",
                     .selection = "all",
                     .command = "bimodal-analysis report 'a b.sqlite' -o report"};

TEST(PageOfFaces, ComparesTheNamedConditionsInEveryUnitOnce) {
  const auto results = compared();
  ASSERT_EQ(results.comparisons.size(), 3U);
  EXPECT_EQ(results.comparisons[1].unit, Unit::Vowel);
  const auto page = report_page(results, {}, kMaking);
  EXPECT_THAT(page, HasSubstr("How alike are the two faces?"));
  EXPECT_THAT(page, HasSubstr("<title>Two conditions compared: Initial consonants</title>"));
  EXPECT_THAT(page, HasSubstr("<caption>Vowels: AV natural (first) and AV synthetic (second)"));
  // 41 of 72 words with the synthetic face, 60 of 72 with the natural one
  EXPECT_THAT(page, HasSubstr("Words correct with AV synthetic are .68 ["));
  EXPECT_THAT(page, HasSubstr("200 permutations of 144 trials, 0 left out."));
  EXPECT_THAT(page, HasSubstr("the conditions are exchanged within participant x word"));
}

TEST(PageOfFaces, IsNotThereUnlessConditionsAreNamed) {
  const auto page = report_page(results_of(five_conditions()), {}, kMaking);
  EXPECT_THAT(page, Not(HasSubstr("id='faces'")));
  EXPECT_THAT(page, HasSubstr("id='benefit'"));
}

TEST(PageOfFaces, NamesTheConditionsThatThereAre) {
  EXPECT_THROW((void)compared("nobody"), Error);
}

TEST(PageOfFaces, HasItsTablesAndFigureFiles) {
  const auto results = compared();
  std::vector<std::string> names;
  for (const auto& file : report_tables(results, kMaking)) names.push_back(file.name);
  EXPECT_THAT(names, Contains("comparison.csv"));
  EXPECT_THAT(names, Contains("contrasts.csv"));
  std::vector<std::string> figures;
  for (const auto& figure : report_figures(results)) figures.push_back(figure.name);
  EXPECT_THAT(figures, Contains("faces-vowel"));
  EXPECT_THAT(figures, Contains("benefit-A"));
  EXPECT_THAT(figures, Contains("features-consonant-final"));
}

TEST(PageOfBenefits, TellsEveryNumberWithItsTrialsAndMethod) {
  const auto page = report_page(compared(), {}, kMaking);
  EXPECT_THAT(page,
              HasSubstr("<th scope='row'>AV natural</th><td>A; V natural</td><td "
                        "class='estimate'>.43 <span class='note'>72</span>"));
  EXPECT_THAT(page, HasSubstr("Of the benefit of AV natural, AV synthetic gives the part .34 ["));
  EXPECT_THAT(page, HasSubstr("crossed bootstrap, 6 participants x 12 words, 200 draws"));
}

// 11 of the 12 words begin with a consonant; each was presented 6 times.
TEST(PageOfFeatures, CountsWhatIsNoConsonantAndLeavesItOut) {
  const auto results = compared();
  const auto found = std::ranges::find_if(results.features, [](const FeatureProfileTable& table) {
    return table.unit == Unit::ConsonantInitial && table.condition == "AV natural";
  });
  ASSERT_NE(found, results.features.end());
  const auto& voicing = found->information.features.at(0);
  EXPECT_EQ(voicing.feature, "voicing");
  ASSERT_TRUE(voicing.information);
  EXPECT_EQ(voicing.information->responses + voicing.left_out, 66.0);
  EXPECT_GT(voicing.left_out, 0.0);  // all wrong answers are blank
  // what is left is right throughout, so that all of it came through
  EXPECT_DOUBLE_EQ(voicing.information->relative.value(), 1.0);
}

TEST(PageForAPaper, SaysWhatWasDoneAndWithWhat) {
  const auto page = report_page(compared(), {}, kMaking);
  EXPECT_THAT(page, HasSubstr("6 participants gave 360 answers to 12 different words in 5 "));
  EXPECT_THAT(page, HasSubstr("X<sup>2</sup> with 200 permutations"));
  EXPECT_THAT(page, HasSubstr("Benjamini"));
  EXPECT_THAT(page,
              HasSubstr("<td class='command'>bimodal-analysis report &#39;a b.sqlite&#39; -o "));
  const auto alone = report_page(results_of(five_conditions()), {}, kMaking);
  EXPECT_THAT(alone, Not(HasSubstr("Benjamini")));  // nothing was tested
}

TEST(PageForAPaper, IsPrintedWithItsCaptions) {
  const auto blocks = read_blocks(report_page(compared(), {}, kMaking));
  const auto has = [&](Block::Kind kind, std::string_view words) {
    return std::ranges::any_of(blocks, [&](const Block& block) {
      return block.kind == kind && block.words.find(words) != std::string::npos;
    });
  };
  EXPECT_TRUE(has(Block::Kind::Term, "Vowels: AV natural (first)"));
  EXPECT_FALSE(has(Block::Kind::Paragraph, "use strict"));
}

}  // namespace
}  // namespace bimodal::analysis

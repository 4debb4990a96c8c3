#include "analysis/report/confusions.hpp"

#include <gmock/gmock.h>

#include "analysis/report/matrix_text.hpp"
#include "analysis/report/printed_number.hpp"
#include "tests/analysis/examples.hpp"

namespace bimodal::analysis {
namespace {

using examples::trial;
using testing::HasSubstr;

class TabulateUnit : public testing::Test {
 protected:
  UnitConfusions tabulate(Unit unit, TieRule ties = TieRule::LeftOut) {
    ScoringRules rules;
    rules.ties = ties;
    const std::vector conditions{std::string{"visual"}};
    const auto scores = score_all(trials_, dictionary_, rules);
    return tabulate_unit(trials_, scores, conditions, unit).front();
  }

 private:
  WrittenFiles folder_;
  Dictionary dictionary_ = examples::dictionary(folder_);
  std::vector<Trial> trials_{trial("stew", "S T UW", "bee"),
                             trial("bat", "B AE T", "ate"),
                             trial("ate", "EY T", "can't"),
                             trial("bada", "", "bat"),
                             trial("bada", "", ""),
                             trial("bat", "B AE T", "zzz")};
};

TEST_F(TabulateUnit, HasClustersInTheOrderOfTheirPhones) {
  EXPECT_EQ(matrix_csv(tabulate(Unit::Onset).matrix),
            "\"stimulus\",\"none\",\"B\",\"S T\",\"K\",\"blank\",\"other\"\n"
            "\"none\",0,0,0,1,0,0\n"
            "\"B\",1,0,0,0,0,1\n"
            "\"S T\",0,1,0,0,0,0\n");
}

TEST_F(TabulateUnit, HasEveryPhoneAndLeavesOutTheAmbiguous) {
  const auto table = tabulate(Unit::Phoneme);
  EXPECT_EQ(table.ambiguous, 2);  // S and T of stew
  EXPECT_EQ(table.lacking, 2);
  EXPECT_EQ(table.without_phones, 2);
  EXPECT_EQ(table.matrix.total(), 1 + 3 + 2 + 3);
  EXPECT_THAT(table.matrix.stimuli(), testing::Contains("S"));  // a row without responses
}

TEST_F(TabulateUnit, CountsInPartsWhereTiesAreAveraged) {
  const auto table = tabulate(Unit::ConsonantInitial, TieRule::Averaged);
  EXPECT_EQ(table.ambiguous, 0);
  EXPECT_THAT(matrix_csv(table.matrix), HasSubstr("\n\"S\",0.5,0,0.5,0,0\n"));
}

TEST_F(TabulateUnit, HasWordsByTheAlphabet) {
  EXPECT_EQ(matrix_csv(tabulate(Unit::Word).matrix),
            "\"stimulus\",\"ate\",\"bada\",\"bat\",\"bee\",\"can't\",\"stew\",\"zzz\",\"blank\"\n"
            "\"ate\",0,0,0,0,1,0,0,0\n"
            "\"bada\",0,0,1,0,0,0,0,1\n"
            "\"bat\",1,0,0,0,0,0,1,0\n"
            "\"stew\",0,0,0,1,0,0,0,0\n");
}

TEST_F(TabulateUnit, TellsHowManyWordsHaveNoPhones) {
  EXPECT_THAT(left_out_text(tabulate(Unit::Vowel)),
              HasSubstr("words without this unit 2 (2 of unknown phones).\n"));
}

TEST(PrintCount, HasADecimalOnlyWhereResponsesAreShared) {
  EXPECT_EQ(print_count(86.0), "86");
  EXPECT_EQ(print_count(85.99999999999999), "86");
  EXPECT_EQ(print_count(0.5), "0.5");
}

}  // namespace
}  // namespace bimodal::analysis

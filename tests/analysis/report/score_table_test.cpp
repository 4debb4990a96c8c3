#include "analysis/report/score_table.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "analysis/report/scored_trials.hpp"
#include "tests/analysis/examples.hpp"

namespace bimodal::analysis {
namespace {

using examples::trial;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

Trial of(std::string participant, Trial made) {
  made.participant = std::move(participant);
  return made;
}

class ScoreTables : public testing::Test {
 protected:
  [[nodiscard]] ScoreTable table(bool by_participant) const {
    const std::vector<std::string> conditions{"visual", "unused"};
    const std::vector<std::string> participants{"P01", "P02"};
    return tabulate_scores(trials_,
                           scores_,
                           conditions,
                           by_participant ? participants : std::vector<std::string>{},
                           rules_);
  }

  ScoringRules rules_ = [] {
    ScoringRules rules;
    rules.tolerate(Tolerance::Plural);
    return rules;
  }();
  std::vector<Trial> trials_{of("P01", trial("bat", "B AE T", "bat")),
                             of("P01", trial("two", "T UW", "too")),
                             of("P01", trial("bat", "B AE T", "bats")),
                             of("P01", trial("stew", "S T UW", "bee")),
                             of("P02", trial("two", "T UW", "tuna")),
                             of("P02", trial("bat", "B AE T", "")),
                             of("P02", trial("bat", "B AE T", "zzz")),
                             of("P02", trial("bada", "", "bat"))};

 private:
  WrittenFiles folder_;

 protected:
  std::vector<Score> scores_ = score_all(trials_, examples::dictionary(folder_), rules_);
};

TEST_F(ScoreTables, CountAsByHand) {
  const auto row = table(false).conditions.at(0);
  EXPECT_EQ(row.trials, 8);
  EXPECT_EQ(row.exact, 1);
  EXPECT_EQ(row.homophone, 1);
  EXPECT_EQ(row.tolerated, 1);
  EXPECT_EQ(row.wrong, 3);
  EXPECT_EQ(row.omissions, 1);
  EXPECT_EQ(row.out_of_dictionary, 1);
  EXPECT_EQ(row.word_proportion(), 3.0 / 8.0);
  EXPECT_EQ(row.no_pronunciation, 1);
  // bat 3/3, two 2/2, bats 3/3, stew as bee 0/3, two as tuna 2/2, blank 0/3
  EXPECT_EQ(row.phonemes, 16);
  EXPECT_EQ(row.phonemes_correct, 10);
  EXPECT_EQ(row.insertions, 2);  // N AH of tuna
  EXPECT_EQ(row.aligned, 2);     // stew, two
  EXPECT_EQ(row.ambiguous, 1);   // did S or T become B?
  EXPECT_EQ(row.ambiguous_proportion(), 0.5);
}

TEST_F(ScoreTables, OfAConditionAreTheSumOfItsParticipants) {
  const auto made = table(true);
  ASSERT_EQ(made.participants.size(), 2U);  // none of the unused condition
  EXPECT_EQ(made.participants[0].participant, "P01");
  EXPECT_EQ(made.participants[0].trials + made.participants[1].trials, made.conditions[0].trials);
  EXPECT_EQ(made.participants[0].phonemes_correct + made.participants[1].phonemes_correct,
            made.conditions[0].phonemes_correct);
}

TEST_F(ScoreTables, HaveNoProportionOfNothing) {
  const auto read = json::parse(score_json(table(false)));
  const auto& unused = read["conditions"][1];
  EXPECT_EQ(unused["n"], 0);
  EXPECT_TRUE(unused["word_proportion"].is_null());
  EXPECT_TRUE(unused["phoneme_proportion"].is_null());
  EXPECT_TRUE(unused["ambiguous_proportion"].is_null());
}

TEST_F(ScoreTables, GiveJsonTheRulesAndEveryFigure) {
  const auto read = json::parse(score_json(table(true)));
  EXPECT_EQ(read["rules"]["tolerate"], json::array({"plural"}));
  EXPECT_EQ(read["rules"]["homophones"], true);
  EXPECT_EQ(read["rules"]["out_of_dictionary"], "leave-out");
  EXPECT_EQ(read["rules"]["costs"], "unit");
  EXPECT_EQ(read["rules"]["ties"], "leave-out");
  const auto& row = read["conditions"][0];
  EXPECT_EQ(row["condition"], "visual");
  EXPECT_FALSE(row.contains("participant"));
  EXPECT_EQ(row["tolerated"], 1);
  EXPECT_EQ(row["phoneme_proportion"], 10.0 / 16.0);
  EXPECT_EQ(read["participants"][1]["participant"], "P02");
  EXPECT_EQ(read["participants"][1]["omissions"], 1);
}

TEST_F(ScoreTables, GiveCsvOneLineARow) {
  EXPECT_THAT(
      score_csv(table(true)),
      AllOf(HasSubstr("\"condition\",\"participant\",\"n\",\"exact\",\"homophone\",\"tolerated\","),
            HasSubstr("\n\"visual\",,8,1,1,1,3,1,1,0.375,1,16,10,0.625,2,2,1,0.5\n"),
            HasSubstr("\n\"visual\",\"P01\",4,"),
            HasSubstr("\n\"unused\",,0,0,0,0,0,0,0,,0,0,0,,0,0,0,\n")));
}

TEST_F(ScoreTables, TellPeopleTheRules) {
  EXPECT_THAT(score_text(table(false)),
              AllOf(HasSubstr("Tolerated: plural."), HasSubstr(".38"), HasSubstr("visual")));
}

TEST_F(ScoreTables, OfTrialsHaveALineForEachWithItsAlignment) {
  EXPECT_EQ(print_alignment(scores_[3]), "S>deleted(.50)/B(.50) T>deleted(.50)/B(.50) UW>IY");
  EXPECT_EQ(print_alignment(scores_[5]), "B>blank AE>blank T>blank");
  EXPECT_EQ(print_alignment(scores_[7]), "");
  const auto read = json::parse(scored_trials_json(trials_, scores_))["trials"];
  ASSERT_EQ(read.size(), 8U);
  EXPECT_EQ(read[2]["verdict"], "tolerated");
  EXPECT_EQ(read[2]["rule"], "plural");
  EXPECT_EQ(read[2]["answer_phones"], "B AE T");
  EXPECT_EQ(read[4]["answer_phones"], "T UW N AH");
  EXPECT_EQ(read[4]["insertions"], 2);
  EXPECT_TRUE(read[6]["phonemes_correct"].is_null());
  EXPECT_TRUE(read[7]["alignment"].is_null());
  const auto csv = scored_trials_csv(trials_, scores_);
  EXPECT_EQ(std::ranges::count(csv, '\n'), 9);
  EXPECT_THAT(csv,
              HasSubstr("\"two\",\"tuna\",\"tuna\",\"wrong\",,0,\"T UW\",\"T UW N AH\",\"T>T "
                        "UW>UW\",2,2,2\n"));
  EXPECT_THAT(scored_trials_text(trials_, scores_),
              HasSubstr("\nP02\t0\tvisual\tbat\t\t\tomission\t\t0\tB AE T\t\tB>blank AE>blank "
                        "T>blank\t3\t0\t0\n"));
}

}  // namespace
}  // namespace bimodal::analysis

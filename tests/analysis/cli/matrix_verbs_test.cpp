
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "analysis/cli/program.hpp"
#include "tests/analysis/cli/program_run.hpp"
#include "tests/analysis/examples.hpp"

namespace bimodal::analysis {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

class MatrixVerbs : public testing::Test {
 protected:
  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    return files_.write(name, text).string();
  }

  WrittenFiles files_;
};

constexpr const char* kMatrix = "stimulus,p,b,m,blank\np,20,3,1,0\nb,5,15,2,2\nm,0,4,18,1\n";
constexpr const char* kFeatures = "label,voicing,nasality\np,-,-\nb,+,-\nm,+,+\n";

TEST_F(MatrixVerbs, PrintsEveryFigureAsJson) {
  const auto made = run(
      {"information", file("m.csv", kMatrix), "--features", file("f.csv", kFeatures), "--json"});
  ASSERT_EQ(made.code, ExitCode::Done) << made.err;
  const auto read = json::parse(made.out);
  EXPECT_EQ(read["n"], 71);
  // scipy.stats.entropy, see information_test.cpp
  EXPECT_NEAR(read["stimulus_entropy_bits"], 1.5846749360690935, 1e-12);
  EXPECT_NEAR(read["transmitted_bits"], 0.7011206416962881, 1e-12);
  ASSERT_EQ(read["features"].size(), 2U);
  const auto& voicing = read["features"][0];
  EXPECT_EQ(voicing["feature"], "voicing");
  EXPECT_EQ(voicing["left_out"], 3);
  EXPECT_EQ(voicing["n"], 68);
  EXPECT_NEAR(voicing["transmitted_bits"], 0.38891884821952427, 1e-12);
  EXPECT_NEAR(read["features"][1]["transmitted_bits"], 0.4352162895513578, 1e-12);
}

TEST_F(MatrixVerbs, PrintsATableForPeopleAndOneForPrograms) {
  const auto matrix = file("m.csv", kMatrix);
  const auto features = file("f.csv", kFeatures);
  const auto text = run({"information", matrix, "--features", features});
  EXPECT_THAT(text.out, AllOf(HasSubstr("(all)"), HasSubstr("voicing"), HasSubstr("3 left out")));
  EXPECT_THAT(text.out, HasSubstr("with 23.7 responses each"));
  const auto csv = run({"information", matrix, "--features", features, "--csv"});
  EXPECT_THAT(csv.out,
              AllOf(HasSubstr("\"feature\",\"left_out\""), HasSubstr("\n\"nasality\",3,68,")));
}

TEST_F(MatrixVerbs, RefusesWhatDoesNotFitTogether) {
  const auto matrix = file("m.csv", kMatrix);
  const auto few = run({"information", matrix, "--features", file("g.csv", "label,v\np,-\n")});
  EXPECT_EQ(few.code, ExitCode::InvalidInput);
  EXPECT_THAT(few.err, HasSubstr("no line for the stimulus \"b\""));
  EXPECT_THAT(run({"information", matrix, "--unit", "vowel"}).err, HasSubstr("leave out --unit"));
  EXPECT_THAT(run({"information", matrix, "--ties", "average"}).err,
              HasSubstr("and the rules of scoring"));
  EXPECT_THAT(run({"information", matrix, matrix}).err, HasSubstr("name one matrix"));
  EXPECT_EQ(run({"information", matrix, "--json", "--csv"}).code, ExitCode::Usage);
  const auto empty = run({"information", file("e.csv", "s,p\np,0\n")});
  EXPECT_EQ(empty.code, ExitCode::Findings);
  EXPECT_THAT(empty.err, HasSubstr("the matrix has no responses"));
  EXPECT_THAT(run({"information", "x.sqlite"}).err, HasSubstr("Give --unit"));
  EXPECT_THAT(empty.out, IsEmpty());
}

TEST_F(MatrixVerbs, SinfaTellsItsRoundsInOrder) {
  const auto matrix = file("m.csv", kMatrix);
  const auto features = file("f.csv", kFeatures);
  const auto text = run({"sinfa", matrix, "--features", features});
  EXPECT_THAT(text.out,
              AllOf(HasSubstr("68 responses analysed, 3 left out"), HasSubstr("round 2")));
  const auto read = json::parse(run({"sinfa", matrix, "--features", features, "--json"}).out);
  EXPECT_EQ(read["rounds"][0]["chosen"], json::array({"nasality"}));
  EXPECT_NEAR(read["rounds"][0]["candidates"][1]["transmitted_bits"], 0.4352162895513578, 1e-12);
  const auto csv = run({"sinfa", matrix, "--features", features, "--csv"});
  EXPECT_THAT(csv.out, HasSubstr("\n1,68,\"nasality\","));
  EXPECT_EQ(run({"sinfa", matrix}).code, ExitCode::Usage);
}

TEST_F(MatrixVerbs, ClusterTellsMergesAndClasses) {
  const auto matrix = file("m.csv", kMatrix);
  const auto text = run({"cluster", matrix, "--linkage", "average", "--criterion", "0.7"});
  EXPECT_THAT(text.out,
              AllOf(HasSubstr("average linkage"), HasSubstr("p + b"), HasSubstr("/p b/")));
  const auto read = json::parse(run({"cluster", matrix, "--criterion", "0.7", "--json"}).out);
  EXPECT_EQ(read["merges"].size(), 2U);
  EXPECT_EQ(read["classes"][0]["members"], json::array({"p", "b"}));
  EXPECT_NEAR(read["classes"][0]["kept"], 43.0 / 48.0, 1e-12);
  EXPECT_EQ(run({"cluster", matrix, "--linkage", "median"}).code, ExitCode::Usage);
  EXPECT_EQ(run({"cluster", matrix, "--criterion", "75"}).code, ExitCode::Usage);
}

TEST_F(MatrixVerbs, MdsTellsWhereStimuliLie) {
  const auto matrix = file("m.csv", kMatrix);
  const auto read = json::parse(run({"mds", matrix, "--json"}).out);
  ASSERT_EQ(read["points"].size(), 3U);
  EXPECT_EQ(read["points"][0]["at"].size(), 2U);
  EXPECT_LT(read["stress_1"], 1e-6);  // three things always lie in a plane
  EXPECT_THAT(run({"mds", matrix}).out, HasSubstr("stress-1 0.000"));
  EXPECT_THAT(run({"mds", matrix, "--csv", "--dimensions", "1"}).out,
              HasSubstr("\"label\",\"dimension_1\"\n\"p\","));
}

TEST_F(MatrixVerbs, ProportionsHaveFiveIntervalsALine) {
  const auto counts = file("p.csv", "condition,k,n\nvisual,86,120\n\"NA\",0,0\n");
  const auto read = json::parse(run({"proportions", counts, "--json"}).out);
  const auto& visual = read["rows"][0];
  EXPECT_EQ(visual["labels"]["condition"], "visual");
  EXPECT_NEAR(visual["intervals"]["clopper-pearson"][0], 0.6271794615782887, 1e-9);
  EXPECT_EQ(visual["intervals"].size(), 5U);
  EXPECT_TRUE(read["rows"][1]["proportion"].is_null());
  EXPECT_EQ(read["rows"][1]["labels"]["condition"], "NA");
  const auto text = run({"proportions", counts});
  EXPECT_THAT(text.out,
              AllOf(HasSubstr("visual: k = 86, n = 120, p = 0.7167"),
                    HasSubstr("NA: k = 0, n = 0: no trials")));
  EXPECT_THAT(run({"proportions", counts, "--csv"}).out, HasSubstr("\n\"NA\",0,0,,,,"));
  EXPECT_THAT(run({"proportions", file("q.csv", "k,n\n3,2\n")}).err,
              HasSubstr("q.csv:2: \"3\" of \"2\" is no number of successes"));
  EXPECT_THAT(run({"proportions", file("r.csv", "k,m\n3,2\n")}).err, HasSubstr("no column \"n\""));
}

}  // namespace
}  // namespace bimodal::analysis


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
  const auto folder = run({"information", files_.folder().string()});
  EXPECT_EQ(folder.code, ExitCode::InvalidInput);
  EXPECT_THAT(folder.err, HasSubstr("it is a folder; name a file"));
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

// By hand: the P row of kMatrix is 20, 3, 1; classes put P, B and M together.
TEST_F(MatrixVerbs, PutsLabelsTogetherAndLooksWithinClasses) {
  const auto matrix = file("m.csv", kMatrix);
  const auto made = run({"matrix", matrix, "--classes", "owens-blazek", "--json"});
  ASSERT_EQ(made.code, ExitCode::Done) << made.err;
  const auto read = json::parse(made.out);
  EXPECT_EQ(read["stimuli"], json::parse(R"(["P B M"])"));
  EXPECT_EQ(read["counts"], json::parse("[[68, 3]]"));
  EXPECT_EQ(read["within_classes"][0]["n"], 68);
  EXPECT_NEAR(read["within_classes"][0]["correct"], 53.0 / 68.0, 1e-12);
  EXPECT_THAT(run({"matrix", matrix, "--classes", "place"}).out, HasSubstr("Within classes"));
  const auto classes = file("c.csv", "label,class\np,stop\nb,stop\n");
  EXPECT_THAT(run({"matrix", matrix, "--classes", classes, "--csv"}).out,
              HasSubstr("\"stop\",43,"));
  EXPECT_THAT(run({"matrix", matrix, "--classes", "clusters"}).out, HasSubstr("by chance"));
  EXPECT_THAT(run({"matrix", matrix, "--classes", "labial"}).err,
              HasSubstr("there are no classes \"labial\""));
}

TEST_F(MatrixVerbs, HasAnIntervalOfInformationOrSaysWhyNot) {
  const auto matrix = file("m.csv", kMatrix);
  const auto read = json::parse(run({"information", matrix, "--json"}).out);
  const auto& interval = read["transmitted_interval"];
  EXPECT_GE(interval["measured_coverage"], 0.9);
  EXPECT_LT(interval["interval"][0], 0.7011206416962881);
  EXPECT_GT(interval["interval"][1], read["transmitted_jackknife_bits"].get<double>());
  EXPECT_EQ(read["data"]["seed"], 1);
  const auto few = run({"information", file("f.csv", "s,p,b\np,2,1\nb,1,2\n")});
  EXPECT_THAT(few.out, HasSubstr("There is no interval: "));
  EXPECT_THAT(run({"information", matrix, "--no-intervals"}).out, HasSubstr("none was asked for"));
}

TEST_F(MatrixVerbs, TellsWhatOfTheLexiconIsToldApart) {
  const auto lexicon = file("l.csv", "word,phonemes\npat,P AE T\nbat,B AE T\nsee,S IY\n");
  const auto made = run({"cluster",
                         file("m.csv", kMatrix),
                         "--equivalence",
                         "--lexicon",
                         lexicon,
                         "--criterion",
                         "1",
                         "--json"});
  const auto read = json::parse(made.out);
  EXPECT_EQ(read["lexicon"]["words"], 3);
  EXPECT_EQ(read["lexicon"]["unique"], 1);
  EXPECT_EQ(read["classes_at"].size(), 3U);
}

TEST_F(MatrixVerbs, EveryVerbTakesSeedAndResamples) {
  const auto matrix = file("m.csv", kMatrix);
  for (const std::string verb : {"matrix", "information", "cluster", "mds", "export"}) {
    std::vector<std::string> line{verb, matrix, "--seed", "3", "--resamples", "200"};
    if (verb == "export") line.insert(line.end(), {"--format", "json"});
    EXPECT_EQ(run(line).code, ExitCode::Done) << verb;
  }
}

}  // namespace
}  // namespace bimodal::analysis

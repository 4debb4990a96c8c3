#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "analysis/cli/program.hpp"
#include "stimuli/base/digest.hpp"
#include "tests/analysis/cli/program_run.hpp"
#include "tests/analysis/examples.hpp"

namespace bimodal::analysis {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class ExportVerb : public testing::Test {
 protected:
  WrittenFiles files_;
  const std::string matrix_ =
      files_.write("m.csv", "stimulus,p,b,m,blank\np,20,3,1,0\nb,5,15,2,2\nm,0,4,18,1\n").string();
};

TEST_F(ExportVerb, WritesFilesThatEveryVerbReads) {
  const auto information_of = [](const std::string& file) {
    auto read = nlohmann::json::parse(run({"information", file, "--json"}).out);
    read.erase("data");  // which names the file
    return read;
  };
  const auto wanted = information_of(matrix_);

  struct Form {
    const char* format;
    const char* file;
  };

  for (const auto& [format, name] : {Form{"csv", "a.csv"},
                                     Form{"long", "b.csv"},
                                     Form{"json", "c.json"},
                                     Form{"praat", "d.Confusion"},
                                     Form{"praat", "e.txt"}}) {
    const auto file = (files_ / name).string();
    const auto made = run({"export", matrix_, "--format", format, "-o", file});
    ASSERT_EQ(made.code, ExitCode::Done) << made.err;
    EXPECT_EQ(made.out, file + "\n");
    EXPECT_EQ(information_of(file), wanted) << format;
  }
}

TEST_F(ExportVerb, PrintsWhereNoFileIsNamed) {
  const auto made = run({"export", matrix_, "--format", "Markdown", "--title", "Lips"});
  EXPECT_EQ(made.code, ExitCode::Done);
  EXPECT_THAT(made.out, AllOf(StartsWith("**Lips**"), HasSubstr("| 20 (.83) |")));
  EXPECT_THAT(run({"export", matrix_, "--format", "csv", "--bare", "--proportions"}).out,
              StartsWith("\"stimulus\",\"p\",\"b\",\"m\",\"blank\"\n\"p\",0.8333333333333334,"));
  EXPECT_THAT(run({"export", matrix_, "--format", "latex", "--order", "clusters"}).out,
              HasSubstr("Order: leaves of the dendrogram"));
}

TEST_F(ExportVerb, KeepsWarningsWithTheCounts) {
  const auto simulated =
      files_.write("s.csv", "# warning: SIMULATED sessions\ns,p,b\np,3,1\nb,0,4\n").string();
  const auto file = (files_ / "s.json").string();
  EXPECT_THAT(run({"export", simulated, "--format", "json", "-o", file}).err,
              HasSubstr("warning: SIMULATED sessions"));
  EXPECT_THAT(run({"information", file}).err, HasSubstr("warning: SIMULATED sessions"));
  EXPECT_THAT(run({"export", file, "--format", "markdown"}).out,
              HasSubstr("Warning: SIMULATED sessions."));
}

TEST_F(ExportVerb, TakesAListOfCountsForNoTrials) {
  const std::string header = "condition,stimulus,response,count\n";
  const auto one = files_.write("one.csv", header + "V,p,p,3\nV,p,b,1\n").string();
  EXPECT_THAT(run({"export", one, "--format", "csv", "--bare"}).out, HasSubstr("\"p\",3,1\n"));
  const auto two = files_.write("two.csv", header + "V,p,p,3\nA,p,p,9\n").string();
  EXPECT_THAT(run({"export", two, "--format", "csv"}).err, HasSubstr("keep the lines of one"));
}

TEST_F(ExportVerb, RefusesWhatHasNoMeaning) {
  const auto refused = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"export", matrix_});
    const auto made = run(arguments);
    EXPECT_EQ(made.code, ExitCode::Usage);
    EXPECT_THAT(made.out, IsEmpty());
    return made.err;
  };
  EXPECT_THAT(refused({}), HasSubstr("--format is required"));
  EXPECT_THAT(refused({"--format", "xlsx"}), HasSubstr("xlsx"));
  EXPECT_THAT(refused({"--format", "praat", "--proportions"}), HasSubstr("is for --format csv"));
  EXPECT_THAT(refused({"--format", "json", "--bare"}), HasSubstr("is for --format csv and long"));
  EXPECT_THAT(refused({"--format", "json", "-o", (files_ / "none/x.json").string()}),
              HasSubstr("there is no folder"));
}

}  // namespace
}  // namespace bimodal::analysis

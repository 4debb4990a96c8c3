#include "analysis/data/matrix_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/fault_of.hpp"

namespace bimodal::analysis {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string fault_in(std::string_view text) {
  return fault_of([&] { return parse_matrix(text, "m.csv"); });
}

TEST(MatrixFile, KeepsEveryLabelAndRectangularCounts) {
  const auto matrix = parse_matrix("stimulus,NA,BA,blank\r\nNA,3,0,1\r\n\"B,A\",0, 7 ,0\r\n", "m");
  EXPECT_THAT(matrix.stimuli(), ElementsAre("NA", "B,A"));
  EXPECT_THAT(matrix.responses(), ElementsAre("NA", "BA", "blank"));
  EXPECT_EQ(matrix.count(0, 2), 1);
  EXPECT_EQ(matrix.count(1, 1), 7);
  EXPECT_EQ(matrix.total(), 11);
}

TEST(MatrixFile, KeepsRowsAndColumnsWithoutResponses) {
  const auto matrix = parse_matrix(",p,b\np,0,0\nb,0,2\n", "m");
  EXPECT_EQ(matrix.row_total(0), 0);
  EXPECT_EQ(matrix.stimuli().size(), 2U);
}

TEST(MatrixFile, RefusesWhatIsNoMatrixAndSaysWhere) {
  EXPECT_THAT(fault_in(""), HasSubstr("the file is empty; begin with"));
  EXPECT_THAT(fault_in("stimulus\n"), HasSubstr("m.csv:1: there are no responses"));
  EXPECT_THAT(fault_in("s,p\n"), HasSubstr("there are no stimuli"));
  EXPECT_THAT(fault_in("s,p,p\np,1,2\n"), HasSubstr("m.csv:1: the response \"p\" occurs twice"));
  EXPECT_THAT(fault_in("s,p\np,1\np,1\n"), HasSubstr("m.csv:3: the stimulus \"p\" occurs twice"));
  EXPECT_THAT(fault_in("s,\np,1\n"), HasSubstr("m.csv:1: a response has no label"));
  EXPECT_THAT(fault_in("s,p,b\np,1\n"), HasSubstr("m.csv:2: 2 fields, but the first line has 3"));
  EXPECT_THAT(fault_in("s,p\n\xff,1\n"), HasSubstr("not UTF-8"));
  for (const auto* const wrong : {"", "-1", "x", "1e30", "10000000000", "nan", "inf", "3 4"}) {
    EXPECT_THAT(fault_in("s,p,b\np,1," + std::string{wrong} + "\n"),
                AllOf(HasSubstr("m.csv:2: \"" + std::string{wrong} + "\", the response \"b\""),
                      HasSubstr("is no count")));
  }
}

TEST(MatrixFile, TakesCountsInPartsAndRefusesProportions) {
  EXPECT_EQ(parse_matrix("s,p,b\np,1.5,0.25\nb,0,1e1\n", "m").row_total(0), 1.75);
  EXPECT_THAT(fault_in("s,p,b\np,0.75,0.25\nb,0,0\n"), HasSubstr("every row makes 1"));
  EXPECT_THAT(fault_in("s,p,b,m\np,.33,.33,.33\nb,.5,.5,0\n"), HasSubstr("every row makes 1"));
  EXPECT_THAT(fault_in("# cells: row proportions\ns,p\np,1\n"), HasSubstr("m.csv:2: the cells"));
  EXPECT_EQ(parse_matrix("s,p,b\np,1,0\nb,0,1\n", "m").total(), 2);  // one response each
  EXPECT_EQ(parse_matrix("# cells: counts\ns,p,b\np,0.75,0.25\n", "m").total(), 1);
}

TEST(MatrixFile, PassesOverTheLinesBeforeATable) {
  const auto read =
      parse_titled_matrix("\xef\xbb\xbf# title: A, \"b\"\r\n# \r\n\r\n#s,# p\r\n# q,1\r\n", "m");
  EXPECT_EQ(read.title, "A, \"b\"");
  EXPECT_THAT(read.matrix.stimuli(), ElementsAre("# q"));
  EXPECT_THAT(read.matrix.responses(), ElementsAre("# p"));
  EXPECT_THAT(fault_in("# a\n# b\ns,p\np,x\n"), HasSubstr("m.csv:4: \"x\""));
  EXPECT_THAT(fault_in("# a\n# b"), HasSubstr("the file is empty"));
}

TEST(MatrixFile, ReadsAListOfCells) {
  const auto read = parse_titled_matrix(
      "# title: T\ncondition,response,stimulus,count\nV,NA,p,2\nV,p,p,0.5\nV,p,b,1\n", "m");
  EXPECT_EQ(read.title, "T");
  EXPECT_THAT(read.matrix.stimuli(), ElementsAre("p", "b"));
  EXPECT_THAT(read.matrix.responses(), ElementsAre("NA", "p"));
  EXPECT_EQ(read.matrix.count(0, 1), 0.5);
  EXPECT_EQ(read.matrix.count(1, 0), 0);  // a pair without a line
  EXPECT_THAT(
      fault_in("stimulus,response,count\np,b,1\np,b,1\n"),
      HasSubstr("m.csv:3: the response \"b\" to \"p\" is counted twice; keep the lines of"));
  EXPECT_THAT(fault_in("stimulus,response,count\np,b,-1\n"), HasSubstr("is no count"));
  EXPECT_THAT(fault_in("stimulus,response,count\n,b,1\n"), HasSubstr("a stimulus has no label"));
  EXPECT_THAT(fault_in("stimulus,response,count\n"), HasSubstr("there are no stimuli"));
}

TEST(MatrixFile, RefusesAListThatWouldFillTheMemory) {
  std::string list = "stimulus,response,count\n";
  for (int i = 0; i < 3'000; ++i) list += fmt::format("s{},r{},1\n", i, i);
  EXPECT_THAT(fault_in(list), HasSubstr("more than 4000000 cells"));
}

TEST(MatrixFile, ReadsJson) {
  const auto read = parse_titled_matrix(
      R"( {"title": "T", "stimuli": ["NA"], "responses": ["NA", "b\"c"], "counts": [[2, 0.5]],
           "made by": "hand"})",
      "m");
  EXPECT_EQ(read.title, "T");
  EXPECT_THAT(read.matrix.responses(), ElementsAre("NA", "b\"c"));
  EXPECT_EQ(read.matrix.count(0, 1), 0.5);
  EXPECT_THAT(fault_in("{\n\"stimuli\": [\"p\"],\n\"responses\": [\"p\", \"p\"],\n"
                       "\"counts\": [[1,\n-2]]}"),
              AllOf(HasSubstr("m.csv:3: /responses/1: the response \"p\" occurs twice"),
                    HasSubstr("m.csv:5: /counts/0/1: -2 is no count")));
  EXPECT_THAT(fault_in(R"({"stimuli": ["p"], "responses": ["p"], "counts": [[1, 2]]})"),
              HasSubstr("/counts/0: 2 counts for 1 responses"));
  EXPECT_THAT(fault_in(R"({"stimuli": ["p"], "responses": ["p"], "counts": [[1], [2]]})"),
              HasSubstr("/counts: 2 lists of counts, but 1 stimuli"));
  EXPECT_THAT(fault_in(R"({"orientation": "columns are stimuli", "stimuli": ["p"],
                           "responses": ["p"], "counts": [[1]]})"),
              HasSubstr("/orientation: \"columns are stimuli\" is another orientation"));
  EXPECT_THAT(fault_in(R"({"stimuli": [1], "responses": ["p"], "counts": [[true]]})"),
              AllOf(HasSubstr("/stimuli/0: 1 is no label"), HasSubstr("true is no count")));
  EXPECT_THAT(fault_in("{}"), HasSubstr("stimuli"));
}

/// As Praat 6.3 wrote it, from "Create simple Confusion" and "Increase confusion count".
constexpr std::string_view kPraat =
    "File type = \"ooTextFile\"\nObject class = \"Confusion\"\n\nnumberOfColumns = 2 \n"
    "columnLabels []: \n\"u\"\t\"i \"\"y\"\"\"\t\nnumberOfRows = 1 \nrow [1]: \"u\"\t3\t0.5\n";

TEST(MatrixFile, ReadsAConfusionOfPraat) {
  const auto matrix = parse_matrix(kPraat, "m");
  EXPECT_THAT(matrix.stimuli(), ElementsAre("u"));
  EXPECT_THAT(matrix.responses(), ElementsAre("u", "i \"y\""));
  EXPECT_EQ(matrix.count(0, 1), 0.5);
  std::string utf16 = "\xfe\xff";
  for (const char letter : kPraat) utf16 += {'\0', letter};
  EXPECT_EQ(parse_matrix(utf16, "m").responses(), matrix.responses());
  const std::string text{kPraat};
  EXPECT_THAT(fault_in(text.substr(0, text.size() - 4)), HasSubstr("m.csv:8: the file ends where"));
  EXPECT_THAT(fault_in(text + "row [2]: \"i\"\n"), HasSubstr("something follows the last row"));
  EXPECT_THAT(fault_in("File type = \"ooTextFile\"\nObject class = \"Sound 2\"\n"),
              HasSubstr("m.csv:2: the object is a \"Sound 2\""));
  EXPECT_THAT(fault_in("File type = \"ooTextFile\"\nObject class = \"Confusion\"\n-1"),
              HasSubstr("m.csv:3"));
}

TEST(MatrixFile, IsAMatrixOrIsRefusedWhateverTheBytes) {
  Damage damage{17};
  for (const std::string& good :
       {std::string{"# title: T\nstimulus,p,b\np,20,3\nb,5,15\n"},
        std::string{"stimulus,response,count\np,p,20\np,b,3\nb,b,15\n"},
        std::string{R"({"stimuli": ["p"], "responses": ["p", "b"], "counts": [[2, 0.5]]})"},
        std::string{kPraat}}) {
    for (int round = 0; round < 10'000; ++round) {
      try {
        const auto matrix = parse_matrix(damage(good), "m.csv");
        EXPECT_GE(matrix.total(), 0);
        EXPECT_FALSE(matrix.stimuli().empty());
      } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("m.csv"));
      }
    }
  }
}

}  // namespace
}  // namespace bimodal::analysis

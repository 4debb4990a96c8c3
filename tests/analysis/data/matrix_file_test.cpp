#include "analysis/data/matrix_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"
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
  for (const auto* const wrong : {"", "0.5", "-1", "x", "1e3", "10000000000", "3 4"}) {
    EXPECT_THAT(fault_in("s,p,b\np,1," + std::string{wrong} + "\n"),
                AllOf(HasSubstr("m.csv:2: \"" + std::string{wrong} + "\", the response \"b\""),
                      HasSubstr("is no count")));
  }
}

TEST(MatrixFile, IsAMatrixOrIsRefusedWhateverTheBytes) {
  const std::string good = "stimulus,p,b\np,20,3\nb,5,15\n";
  Random random{17};
  for (int round = 0; round < 20'000; ++round) {
    auto text = good;
    for (auto mutations = 1 + random.below(4); mutations > 0; --mutations) {
      const auto at = random.below(text.size());
      if (random.below(2) == 0) {
        text[at] = static_cast<char>(random.below(256));
      } else {
        text.erase(at, random.below(4));
      }
      if (text.empty()) break;
    }
    try {
      const auto matrix = parse_matrix(text, "m.csv");
      EXPECT_GE(matrix.total(), 0);
      EXPECT_FALSE(matrix.stimuli().empty());
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("m.csv"));
    }
  }
}

}  // namespace
}  // namespace bimodal::analysis

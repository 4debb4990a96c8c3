#include "analysis/data/feature_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/fault_of.hpp"

namespace bimodal::analysis {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string fault_in(std::string_view text) {
  return fault_of([&] { return parse_features(text, "f.csv"); });
}

TEST(FeatureFile, GivesEachLabelItsValueAndNoneToOthers) {
  const auto table = parse_features("label,voicing,place\nNA,1,0\nB,1,\n", "f.csv");
  EXPECT_THAT(table.features, ElementsAre("voicing", "place"));
  EXPECT_THAT(table.values_of({"B", "blank", "NA"}, 0), ElementsAre("1", "", "1"));
  EXPECT_THAT(table.values_of({"B", "NA"}, 1), ElementsAre("", "0"));
}

TEST(FeatureFile, RefusesWhatIsNoTableAndSaysWhere) {
  EXPECT_THAT(fault_in(""), HasSubstr("there are no features in the first line"));
  EXPECT_THAT(fault_in("label,a\n"), HasSubstr("there are no labels"));
  EXPECT_THAT(fault_in("label,a,\np,1,2\n"), HasSubstr("f.csv:1: a feature has no name"));
  EXPECT_THAT(fault_in("label,a,a\np,1,2\n"), HasSubstr("f.csv:1: the feature \"a\" occurs twice"));
  EXPECT_THAT(fault_in("label,a\np,1,2\n"), HasSubstr("f.csv:2: 3 fields"));
  EXPECT_THAT(fault_in("label,a\np,1\np,1\n"), HasSubstr("f.csv:3: the label \"p\" occurs twice"));
  EXPECT_THAT(fault_in("label,a\n,1\n"), HasSubstr("f.csv:2: a line has no label"));
}

}  // namespace
}  // namespace bimodal::analysis

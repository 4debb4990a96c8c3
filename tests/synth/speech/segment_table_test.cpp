#include "synth/speech/segment_table.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::synth {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using testing::HasSubstr;
using enum Phone;

std::filesystem::path english() {
  return asset("synth/assets/segments/english.json");
}

/// The shipped table as a tree, to be spoilt.
json english_tree() {
  return json::parse(read_file(english()));
}

/// All messages about a table, one a line.
std::string complaints(const std::string& text) {
  std::vector<Diagnostic> diagnostics;
  const auto table = SegmentTable::parse(text, "spoilt.json", diagnostics);
  EXPECT_EQ(table.has_value(), !has_errors(diagnostics));
  std::string all;
  for (const auto& diagnostic : diagnostics) all += describe(diagnostic) + "\n";
  return all;
}

TEST(EnglishSegments, AreReadWithoutComplaint) {
  EXPECT_EQ(complaints(read_file(english())), "");
}

TEST(EnglishSegments, SetEveryControlOfEverySegmentWithItsSources) {
  const SegmentTable table{english()};
  for (const Phone segment : all_phones().first(kFaceSegmentCount)) {
    for (const auto& control : controls().first<kSpeechControlCount>()) {
      const auto& asked = table.at(segment, control.control);
      EXPECT_GT(asked.dominance.alpha, 0) << symbol(segment) << ' ' << control.name;
      EXPECT_TRUE(table.sources().contains(asked.target_source));
      EXPECT_TRUE(table.sources().contains(asked.dynamics_source));
      // A virtual target may overshoot, but by no more than the control's whole range.
      const double range = control.highest - control.lowest;
      EXPECT_GE(asked.target, control.lowest - range) << symbol(segment) << ' ' << control.name;
      EXPECT_LE(asked.target, control.highest + range) << symbol(segment) << ' ' << control.name;
    }
  }
}

TEST(EnglishSegments, LeaveTheFaceNeutralAtRest) {
  const SegmentTable table{english()};
  for (const auto& control : controls().first<kSpeechControlCount>()) {
    EXPECT_EQ(table.at(Rest, control.control).target, control.neutral) << control.name;
  }
}

// natural-lips: class B P, inner height: alpha 2.49, theta .022, t_o -13 ms; class UW, outer width:
// alpha 1.62, theta .010 to .012, before it .015 to .020.
TEST(EnglishSegments, HaveTheDynamicsFittedToNaturalLips) {
  const SegmentTable table{english()};
  const auto& jaw = table.at(B, Control::Jaw);
  EXPECT_EQ(jaw.dominance, (Dominance{.alpha = 2.49, .theta_before = .022, .theta_after = .022}));
  EXPECT_EQ(jaw.offset, Milliseconds{-13});
  const auto& width = table.at(UW, Control::LipWidth).dominance;
  EXPECT_EQ(width.alpha, 1.62);
  EXPECT_GE(width.theta_before, .015);
  EXPECT_LE(width.theta_before, .020);
  EXPECT_GE(width.theta_after, .010);
  EXPECT_LE(width.theta_after, .012);
}

/// Inner lip height (mm) of unrounded visemes of the head, as the table's source "height" states.
double height(const SegmentTable& table, Phone segment) {
  return 0.97 + 1.42 * table.at(segment, Control::Jaw).target +
         0.93 * (table.at(segment, Control::UpperLipRaise).target -
                 table.at(segment, Control::LowerLipRaise).target);
}

// The fitted openings, moved towards what the head's own mesh needs ("height-fit").
TEST(EnglishSegments, OpenTheLipsInTheOrderOfNaturalTalkers) {
  const SegmentTable table{english()};
  const std::vector order{AA, IY, T, UW};
  EXPECT_TRUE(std::ranges::is_sorted(
      order, std::greater{}, [&](Phone segment) { return height(table, segment); }));
  constexpr double kMoved = 2.2;  // mm
  EXPECT_NEAR(height(table, IY), 11.2, kMoved);
  EXPECT_NEAR(height(table, T), 6.5, kMoved);
  EXPECT_NEAR(height(table, L), 9.1, kMoved);
}

TEST(SegmentTable, SaysWhereItIsNotJson) {
  EXPECT_THAT(complaints("{\n\"sources\": {},\n\"groups\": }"),
              HasSubstr("spoilt.json:3: not JSON"));
}

TEST(SegmentTable, RefusesAnUnknownSegment) {
  auto tree = english_tree();
  tree["groups"]["tuck"]["rows"]["Q"] = tree["groups"]["tuck"]["rows"]["F V"];
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("/groups/tuck/rows/Q: \"Q\" is not a segment"));
}

TEST(SegmentTable, RefusesARowForADiphthong) {
  auto tree = english_tree();
  tree["groups"]["tuck"]["rows"]["AY"] = tree["groups"]["tuck"]["rows"]["F V"];
  EXPECT_THAT(complaints(tree.dump()),
              HasSubstr("\"AY\" is two segments for the face; give AA IH"));
}

TEST(SegmentTable, RefusesAnUnknownControl) {
  auto tree = english_tree();
  tree["groups"]["tuck"]["columns"][6] = "lower_lip_tick";
  EXPECT_THAT(complaints(tree.dump()),
              HasSubstr("/groups/tuck/columns/6: \"lower_lip_tick\" is not a control"));
}

TEST(SegmentTable, RefusesAControlThatSpeechDoesNotSet) {
  auto tree = english_tree();
  tree["groups"]["tuck"]["columns"][6] = "head_yaw";
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("\"head_yaw\" is not a control that speech sets"));
}

TEST(SegmentTable, RefusesAControlInTwoGroups) {
  auto tree = english_tree();
  tree["groups"]["tuck"]["columns"][6] = "jaw";
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("\"jaw\" stands in two groups or twice"));
}

TEST(SegmentTable, RefusesAValueWithoutSource) {
  auto tree = english_tree();
  tree["groups"]["tuck"]["rows"]["F V"][5] = "somebody";
  EXPECT_THAT(complaints(tree.dump()),
              HasSubstr("/groups/tuck/rows/F V/5: \"somebody\" is not a source"));
}

TEST(SegmentTable, RefusesDominanceThatIsNotPositive) {
  for (const std::size_t column : {0U, 1U, 2U}) {
    auto tree = english_tree();
    tree["groups"]["tuck"]["rows"]["F V"][column] = 0;
    EXPECT_THAT(complaints(tree.dump()),
                HasSubstr("/groups/tuck/rows/F V/" + std::to_string(column)));
  }
}

TEST(SegmentTable, RefusesAValueThatIsNotANumber) {
  auto tree = english_tree();
  tree["groups"]["tuck"]["rows"]["F V"][6] = "much";
  EXPECT_THAT(complaints(tree.dump()),
              HasSubstr("/groups/tuck/rows/F V/6: \"much\" is not a number"));
}

TEST(SegmentTable, RefusesARowOfTheWrongLength) {
  auto tree = english_tree();
  tree["groups"]["tuck"]["rows"]["F V"].push_back(1);
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("is not a row of 7 values"));
}

TEST(SegmentTable, RefusesAnOffsetBeyondAnySegment) {
  auto tree = english_tree();
  tree["groups"]["tuck"]["rows"]["F V"][3] = 1'000;
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("an offset of 1000 ms is beyond any segment"));
}

TEST(SegmentTable, RefusesASegmentWithoutRow) {
  auto tree = english_tree();
  tree["groups"]["tuck"]["rows"].erase("F V");
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("lower_lip_tuck is not set for F, V"));
}

TEST(SegmentTable, RefusesASegmentWithTwoRows) {
  auto tree = english_tree();
  tree["groups"]["tuck"]["rows"]["V"] = tree["groups"]["tuck"]["rows"]["F V"];
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("V has lower_lip_tuck set already"));
}

TEST(SegmentTable, RefusesAControlWithoutGroup) {
  auto tree = english_tree();
  tree["groups"].erase("tuck");
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("no group has the control lower_lip_tuck"));
}

TEST(SegmentTable, RefusesAKeyThatStandsTwice) {
  EXPECT_THAT(complaints(R"({"sources": {}, "groups": {}, "groups": {}})"),
              HasSubstr(": the same key is already on line"));
}

TEST(SegmentTable, RefusesAnUnknownKey) {
  auto tree = english_tree();
  tree["groups"]["tuck"]["collumns"] = json::array();
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("/groups/tuck/collumns: is not a known key"));
}

TEST(SegmentTable, NamesAllMistakesAtOnce) {
  auto tree = english_tree();
  tree["groups"]["tuck"]["rows"]["F V"][0] = -1;
  tree["groups"]["closure"]["rows"]["P B M"][5] = "somebody";
  const auto all = complaints(tree.dump());
  EXPECT_THAT(all, HasSubstr("/groups/tuck/rows/F V/0"));
  EXPECT_THAT(all, HasSubstr("/groups/closure/rows/P B M/5"));
}

TEST(SegmentTable, RefusesOtherShapesWithoutFailing) {
  for (const std::string text :
       {"[]",
        "1",
        "{}",
        R"({"sources": 1, "groups": 2})",
        R"({"sources": {"a": 1}, "groups": {"g": 3}})",
        R"({"sources": {}, "groups": {"g": {"columns": 1, "rows": []}}})"}) {
    EXPECT_NE(complaints(text), "") << text;
  }
}

TEST(SegmentTable, WarnsOfASourceThatNobodyUses) {
  auto tree = english_tree();
  tree["sources"]["nobody"] = "a paper";
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("/sources/nobody: warning: no row uses"));
}

TEST(SegmentTable, ThrowsWithFileAndFindingsWhenLoadedFromABadFile) {
  const auto file = std::filesystem::path{testing::TempDir()} / "bimodal_bad_segments.json";
  std::ofstream{file} << "{}";
  try {
    const SegmentTable table{file};
    FAIL() << "the file is empty";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string()));
    EXPECT_THAT(error.what(), HasSubstr("\"sources\" is missing"));
    EXPECT_THAT(error.what(), HasSubstr("\"groups\" is missing"));
  }
  std::filesystem::remove(file);
}

/// A file that extends English with one row for T in the group of protrusion.
json variant(double alpha = 0.01) {
  return {{"extends", "english.json"},
          {"sources", {{"mine", "chosen by us for a test"}}},
          {"groups",
           {{"protrusion",
             {{"columns",
               {"alpha",
                "theta_before",
                "theta_after",
                "offset_ms",
                "dynamics",
                "targets",
                "lip_protrusion"}},
              {"rows", {{"T", {alpha, 0.011, 0.012, 3, "mine", "head", 0.5}}}}}}}}};
}

TEST(SegmentVariant, ChangesWhatItSetsAndKeepsTheRest) {
  std::vector<Diagnostic> diagnostics;
  const auto table = SegmentTable::parse(variant().dump(), "variant.json", diagnostics);
  ASSERT_TRUE(table);
  EXPECT_TRUE(diagnostics.empty());
  const SegmentTable base{english()};
  for (const Phone segment : all_phones().first(kFaceSegmentCount)) {
    for (const auto& control : controls().first<kSpeechControlCount>()) {
      const auto& asked = table->at(segment, control.control);
      const bool is_changed = segment == T && control.control == Control::LipProtrusion;
      EXPECT_EQ(asked.dominance == base.at(segment, control.control).dominance, !is_changed);
      EXPECT_EQ(asked.dynamics_source == "mine", is_changed);
    }
  }
  EXPECT_EQ(table->at(T, Control::LipProtrusion).target, 0.5);
}

TEST(SegmentVariant, OfTurkishPlateauShipsWithoutComplaint) {
  const auto file = asset("synth/assets/segments/turkish-plateau.json");
  std::vector<Diagnostic> diagnostics;
  EXPECT_TRUE(SegmentTable::parse(read_file(file), file.string(), diagnostics));
  EXPECT_TRUE(diagnostics.empty());
}

TEST(SegmentVariant, RefusesWhatItCannotExtend) {
  auto tree = variant();
  tree["extends"] = "klingon.json";
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("/extends: \"klingon.json\" cannot be read"));
  tree["extends"] = 3;
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("/extends: 3 is not the name of a file"));
}

TEST(SegmentVariant, NeedsNoSourcesOfItsOwnAndHasAnotherDigest) {
  auto tree = variant();
  EXPECT_TRUE(tree.erase("sources") == 1);
  tree["groups"] = nlohmann::json::object();
  std::vector<Diagnostic> diagnostics;
  const auto table = SegmentTable::parse(tree.dump(), "variant.json", diagnostics);
  ASSERT_TRUE(table) << describe(diagnostics.front());
  const SegmentTable english{asset("synth/assets/segments/english.json")};
  const SegmentTable again{asset("synth/assets/segments/english.json")};
  EXPECT_EQ(english.sha256(), again.sha256());
  EXPECT_EQ(english.sha256().size(), 64U);
  EXPECT_NE(table->sha256(), english.sha256());
}

TEST(SegmentVariant, RefusesASourceOfTheSameNameAsTheFileThatItExtends) {
  auto tree = variant();
  tree["sources"]["lips"] = "others";
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("/sources/lips: the file that this one extends"));
}

TEST(SegmentVariant, RefusesFilesThatExtendEachOtherForEver) {
  const auto folder = std::filesystem::path{testing::TempDir()};
  const auto file = folder / "bimodal_circle.json";
  auto tree = variant();
  tree["extends"] = "bimodal_circle.json";
  std::ofstream{file} << tree.dump();
  std::vector<Diagnostic> diagnostics;
  EXPECT_FALSE(SegmentTable::parse(tree.dump(), file.string(), diagnostics));
  EXPECT_THAT(describe(diagnostics.front()), HasSubstr("extend each other"));
}

TEST(SegmentTable, ReadsFormExponentAndInflection) {
  auto tree = variant();
  auto& group = tree["groups"]["protrusion"];
  group["form"] = "critically damped";
  group["columns"] = {"alpha",
                      "theta_before",
                      "theta_after",
                      "offset_ms",
                      "dynamics",
                      "targets",
                      "exponent",
                      "inflection_ms",
                      "theta_early",
                      "lip_protrusion"};
  group["rows"] = {{"T", {1, 0.01, 0.02, 3, "mine", "head", 1, 68, 0.005, 0.5}},
                   {"S", {1, 0.01, 0.02, 3, "mine", "head", 1.5, nullptr, nullptr, 0.5}}};
  std::vector<Diagnostic> diagnostics;
  const auto table = SegmentTable::parse(tree.dump(), "variant.json", diagnostics);
  ASSERT_TRUE(table) << describe(diagnostics.front());
  const auto& t = table->at(T, Control::LipProtrusion).dominance;
  EXPECT_EQ(t.form, DominanceForm::CriticallyDamped);
  EXPECT_EQ(t.inflection_ms, 68);
  EXPECT_EQ(t.theta_early, 0.005);
  EXPECT_EQ(table->at(S, Control::LipProtrusion).dominance.exponent, 1.5);
  EXPECT_EQ(table->at(S, Control::LipProtrusion).dominance.inflection_ms, Dominance::kNoInflection);

  group["rows"]["T"] = {1, 0.01, 0.02, 3, "mine", "head", 2, 68, 0.005, 0.5};
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("another exponent than 1"));
  group["rows"]["T"] = {1, 0.01, 0.02, 3, "mine", "head", 1, 68, nullptr, 0.5};
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("do not stand together"));
  group["form"] = "square";
  EXPECT_THAT(complaints(tree.dump()), HasSubstr("/form: \"square\" is not a form"));
}

}  // namespace
}  // namespace bimodal::synth

#include "analysis/data/trial_mapping.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/error.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/fault_of.hpp"
#include "tests/support/written_files.hpp"

namespace bimodal::analysis {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// The example of the header.
constexpr std::string_view kExample = R"json({
  "columns": {"participant": "Subj", "condition": ["modality", "talker"],
              "stimulus": "Target", "response": "Typed"},
  "values": {"condition": {"V nat": "natural"}, "response": {"(none)": "", "NA": "na"}},
  "constants": {"phase": "main"}, "delimiter": ";"
})json";

std::string fault_in(std::string_view text) {
  return fault_of([&] { return parse_mapping(text, "m.json"); });
}

TEST(TrialMapping, SaysWhichColumnsMeanWhat) {
  const auto mapping = parse_mapping(kExample, "m.json");
  EXPECT_THAT(mapping.columns.at("participant"), ElementsAre("Subj"));
  EXPECT_THAT(mapping.columns.at("condition"), ElementsAre("modality", "talker"));
  EXPECT_EQ(mapping.values.at("condition").at("V nat"), "natural");
  EXPECT_EQ(mapping.values.at("response").at("(none)"), "");
  EXPECT_EQ(mapping.values.at("response").at("NA"), "na");
  EXPECT_EQ(mapping.constants.at("phase"), "main");
  EXPECT_EQ(mapping.delimiter, ';');
  EXPECT_EQ(parse_mapping("{}", "m.json").delimiter, '\0');
  EXPECT_EQ(parse_mapping(R"({"delimiter": "\t"})", "m.json").delimiter, '\t');
}

TEST(TrialMapping, NamesEveryMistakeAtOnceWithItsPlace) {
  const auto told = fault_in(R"({
  "columns": {"responce": "Typed",
              "stimulus": 7,
              "condition": ["modality", ""],
              "phase": []},
  "values": {"condition": {"a": 1},
             "answer": {"a": "b"}},
  "constants": {"session": 2},
  "delimiter": "|",
  "collumns": {}
})");
  EXPECT_THAT(told,
              AllOf(HasSubstr("m.json:2: /columns/responce: \"responce\" is no field of a trial; "
                              "did you mean \"response\"?"),
                    HasSubstr("m.json:3: /columns/stimulus"),
                    HasSubstr("m.json:4: /columns/condition/1"),
                    HasSubstr("m.json:5: /columns/phase"),
                    HasSubstr("m.json:6: /values/condition/a")));
  EXPECT_THAT(told,
              AllOf(HasSubstr("m.json:7: /values/answer: \"answer\" is no field of a trial"),
                    HasSubstr("m.json:8: /constants/session"),
                    HasSubstr("m.json:9: /delimiter"),
                    HasSubstr("m.json:10: /collumns"),
                    HasSubstr("did you mean \"columns\"?")));
}

TEST(TrialMapping, RefusesWhatIsNoObject) {
  EXPECT_THAT(fault_in(""), HasSubstr("m.json"));
  EXPECT_THAT(fault_in("[]"), HasSubstr("m.json:1"));
  EXPECT_THAT(fault_in("{\"columns\": []}"), HasSubstr("m.json:1: /columns"));
  EXPECT_THAT(fault_in("{\"values\": {\"phase\": \"x\"}}"), HasSubstr("/values/phase"));
  EXPECT_THAT(fault_in("{\n\"columns\": {\n}"), HasSubstr("m.json:3"));
}

TEST(TrialMapping, IsReadFromAFile) {
  const WrittenFiles folder;
  EXPECT_EQ(read_mapping(folder.write("m.json", kExample)).delimiter, ';');
  EXPECT_THAT(fault_of([&] { return read_mapping(folder / "none.json"); }), HasSubstr("none.json"));
}

TEST(TrialMapping, IsReadOrRefusedWhateverTheBytes) {
  Damage damage{19};
  for (int round = 0; round < 10'000; ++round) {
    try {
      static_cast<void>(parse_mapping(damage(std::string{kExample}), "m.json"));
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("m.json"));
    }
  }
}

}  // namespace
}  // namespace bimodal::analysis

#include "analysis/scoring/classes.hpp"

#include <gmock/gmock.h>

#include "analysis/report/place_class.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/timeline/phone.hpp"

namespace bimodal::analysis {
namespace {

using testing::ElementsAre;

/// Rows P B T IY, columns P B T IY blank.
ConfusionMatrix example() {
  return {{"P", "B", "T", "IY"}, {"P", "B", "T", "IY", "blank"}, {6, 3, 1, 0, 2,  //
                                                                  4, 5, 0, 0, 1,  //
                                                                  1, 0, 8, 0, 0,  //
                                                                  0, 0, 0, 9, 1}};
}

TEST(PresetClasses, OfOwensAndBlazekAreTheirVisemes) {
  const auto map = preset_classes("owens-blazek").value();
  EXPECT_EQ(map.class_of("P"), "P B M");
  EXPECT_EQ(map.class_of("M"), "P B M");
  EXPECT_EQ(map.class_of("V"), "F V");
  EXPECT_EQ(map.class_of("DH"), "TH DH");
  EXPECT_EQ(map.class_of("R"), "W R");
  EXPECT_EQ(map.class_of("CH"), "SH ZH CH JH");
  EXPECT_EQ(map.class_of("G"), "T D N S L K G");
  EXPECT_EQ(map.class_of("HH"), "HH");
  EXPECT_EQ(map.class_of("IY"), "IY");
  EXPECT_EQ(map.class_of("blank"), "blank");
}

TEST(PresetClasses, ByFeaturesHaveEveryConsonantAndNoVowel) {
  for (const auto* const named : {"place", "manner", "voicing"}) {
    const auto map = preset_classes(named).value();
    for (const Phone phone : all_phones()) {
      EXPECT_EQ(map.classes.contains(std::string{symbol(phone)}), is_consonant(phone));
    }
  }
  EXPECT_EQ(preset_classes("manner")->class_of("CH"), "affricate");
  EXPECT_EQ(preset_classes("voicing")->class_of("Z"), "voiced");
  EXPECT_FALSE(preset_classes("lips").has_value());
  EXPECT_THAT(preset_class_names(), ElementsAre("owens-blazek", "place", "manner", "voicing"));
}

TEST(PresetClasses, ByPlaceAgreeWithTheLinesOfTheFigures) {
  const auto map = preset_classes("place").value();
  for (const Phone phone : all_phones()) {
    if (!is_consonant(phone)) continue;
    EXPECT_EQ(map.class_of(std::string{symbol(phone)}), place_class(symbol(phone)));
  }
}

TEST(MatrixOfClasses, AddsCountsByHand) {
  const auto classes = matrix_of_classes(example(), *preset_classes("owens-blazek"));
  EXPECT_THAT(classes.stimuli(), ElementsAre("P B M", "T D N S L K G", "IY"));
  EXPECT_THAT(classes.responses(), ElementsAre("P B M", "T D N S L K G", "IY", "blank"));
  EXPECT_EQ(classes.count(0, 0), 18);
  EXPECT_EQ(classes.count(0, 1), 1);
  EXPECT_EQ(classes.count(0, 3), 3);
  EXPECT_EQ(classes.count(1, 0), 1);
  EXPECT_EQ(classes.total(), example().total());
}

TEST(WithinClassConfusions, AreThoseOfTheMembersAlone) {
  const auto within = within_class_confusions(example(), *preset_classes("owens-blazek"));
  ASSERT_EQ(within.size(), 1U);
  EXPECT_EQ(within[0].name, "P B M");
  EXPECT_THAT(within[0].matrix.stimuli(), ElementsAre("P", "B"));
  EXPECT_THAT(within[0].matrix.responses(), ElementsAre("P", "B"));
  EXPECT_NEAR(within[0].correct.value(), 11.0 / 18.0, 1e-12);  // (6 + 5) of (6 + 3 + 4 + 5)
  EXPECT_EQ(within[0].chance, 0.5);
}

TEST(WithinClassConfusions, CountMembersThatWereOnlyAnswered) {
  const ConfusionMatrix matrix{{"P"}, {"P", "M", "blank"}, {1, 2, 3}};
  const auto within = within_class_confusions(matrix, *preset_classes("owens-blazek"));
  ASSERT_EQ(within.size(), 1U);
  EXPECT_EQ(within[0].chance, 0.5);
  EXPECT_NEAR(within[0].correct.value(), 1.0 / 3.0, 1e-12);
}

TEST(WithinClassConfusions, HaveNoProportionWithoutResponses) {
  const ConfusionMatrix matrix{{"P", "B"}, {"P", "B", "blank"}, {0, 0, 3, 0, 0, 0}};
  const auto within = within_class_confusions(matrix, *preset_classes("owens-blazek"));
  ASSERT_EQ(within.size(), 1U);
  EXPECT_FALSE(within[0].correct.has_value());
}

TEST(ParseClasses, ReadsLabelsAsTheyAreWritten) {
  const auto map = parse_classes("label,class\np,labial\nNA,nasal\n\"m,\",\"labial\"\n", "v.csv");
  EXPECT_EQ(map.class_of("NA"), "nasal");
  EXPECT_EQ(map.class_of("m,"), "labial");
  EXPECT_EQ(map.class_of("P"), "P");
  EXPECT_EQ(map.name, "v.csv");
}

std::string refusal(std::string_view text) {
  try {
    static_cast<void>(parse_classes(text, "v.csv"));
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(ParseClasses, RefusesWhatIsNoMap) {
  using testing::HasSubstr;
  EXPECT_THAT(refusal("p,labial\n"), HasSubstr("v.csv:1: the first line does not name"));
  EXPECT_THAT(refusal("label,class\np\n"), HasSubstr("v.csv:2: 1 fields, not 2"));
  EXPECT_THAT(refusal("label,class\np,\n"), HasSubstr("v.csv:2: the label or its class is empty"));
  EXPECT_THAT(refusal("label,class\np,a\np,b\n"), HasSubstr("v.csv:3: the label \"p\" occurs"));
  EXPECT_THAT(refusal("label,class\n"), HasSubstr("no labels"));
  EXPECT_THAT(refusal("label,class\n\xff,b\n"), HasSubstr("not UTF-8"));
}

}  // namespace
}  // namespace bimodal::analysis

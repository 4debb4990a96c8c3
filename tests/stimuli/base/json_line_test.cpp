#include "stimuli/base/json_line.hpp"

#include <gtest/gtest.h>

namespace bimodal {
namespace {

constexpr std::string_view kText = R"({
  "title": "a \"quoted\" { brace",
  "conditions": [
    {"name": "auditory", "snr_db": -8},
    {
      "name": "visual",
      "snr_db": "loud"
    }
  ],
  "a/b~c": [1, [2,
    3]],
  "twice": 1,
  "twice": 2
})";

TEST(JsonLine, CountsLinesUpToAnOffset) {
  EXPECT_EQ(line_of_offset("a\nb\n", 0), 1U);
  EXPECT_EQ(line_of_offset("a\nb\n", 1), 1U);
  EXPECT_EQ(line_of_offset("a\nb\n", 2), 2U);
  EXPECT_EQ(line_of_offset("a\nb", 99), 2U);
  EXPECT_EQ(line_of_offset("", 0), 1U);
}

TEST(JsonLine, FindsWhereTheValueOfAPointerBegins) {
  EXPECT_EQ(line_of_pointer(kText, ""), 1U);
  EXPECT_EQ(line_of_pointer(kText, "/title"), 2U);
  EXPECT_EQ(line_of_pointer(kText, "/conditions"), 3U);
  EXPECT_EQ(line_of_pointer(kText, "/conditions/0/snr_db"), 4U);
  EXPECT_EQ(line_of_pointer(kText, "/conditions/1"), 5U);
  EXPECT_EQ(line_of_pointer(kText, "/conditions/1/snr_db"), 7U);
}

TEST(JsonLine, UnderstandsEscapedPointersAndNestedArrays) {
  EXPECT_EQ(line_of_pointer(kText, "/a~1b~0c/0"), 10U);
  EXPECT_EQ(line_of_pointer(kText, "/a~1b~0c/1/1"), 11U);
}

TEST(JsonLine, TakesTheLastOfTwoEqualKeys) {
  EXPECT_EQ(line_of_pointer(kText, "/twice"), 13U);
}

TEST(JsonLine, SaysNothingOfWhatIsNotThere) {
  EXPECT_EQ(line_of_pointer(kText, "/conditions/2"), std::nullopt);
  EXPECT_EQ(line_of_pointer(kText, "/title/deeper"), std::nullopt);
  EXPECT_EQ(line_of_pointer(kText, "title"), std::nullopt);
  EXPECT_EQ(line_of_pointer("", ""), std::nullopt);
}

TEST(JsonLine, EndsOnEveryPieceOfAText) {
  for (std::size_t size = 0; size < kText.size(); ++size) {
    (void)line_of_pointer(kText.substr(0, size), "/conditions/1/snr_db");
    (void)line_of_pointer(kText.substr(size), "/twice");
  }
}

}  // namespace
}  // namespace bimodal

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/digest.hpp"
#include "stimuli/labels/label_file.hpp"
#include "tests/stimuli/labels/label_cases.hpp"

namespace bimodal {
namespace {

using namespace std::chrono_literals;
using label_cases::fault_of;
using label_cases::replaced;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr std::string_view kLong = R"(File type = "ooTextFile"
Object class = "TextGrid"

xmin = 0 
xmax = 1.5 
tiers? <exists> 
size = 2 
item []: 
    item [1]:
        class = "IntervalTier" 
        name = "phones" 
        xmin = 0 
        xmax = 1.5 
        intervals: size = 3 
        intervals [1]:
            xmin = 0 
            xmax = 0.5 
            text = "" 
        intervals [2]:
            xmin = 0.5 
            xmax = 0.75 
            text = "say ""hi""" 
        intervals [3]:
            xmin = 0.75 
            xmax = 1.5 
            text = " ch)"
                                   "\xC3\xA4"
                                   R"(teau " 
    item [2]:
        class = "TextTier" 
        name = "points" 
        xmin = 0 
        xmax = 1.5 
        points: size = 1 
        points [1]:
            number = 0.25 
            mark = "click" 
)";

constexpr std::string_view kShort = R"(File type = "ooTextFile"
Object class = "TextGrid"

0
1.5
<exists>
2
"IntervalTier"
"phones"
0
1.5
3
0
0.5
""
0.5
0.75
"say ""hi"""
0.75
1.5
" ch)"
                                    "\xC3\xA4"
                                    R"(teau "
"TextTier"
"points"
0
1.5
1
0.25
"click"
)";

Labels expected() {
  return {.end = 1500ms,
          .tiers = {{.name = "phones",
                     .labels = {{500ms, 750ms, "say \"hi\""}, {750ms, 1500ms, "ch\xC3\xA4teau"}}},
                    {.name = "points", .labels = {{250ms, 250ms, "click"}}}}};
}

/// UTF-8 of the Latin-1 characters to Latin-1's code units.
std::u16string code_units(std::string_view text) {
  std::u16string units;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool two = byte >= 0xC0U;
    units += static_cast<char16_t>(
        two ? ((byte & 0x1FU) << 6U) | (static_cast<unsigned char>(text[i + 1]) & 0x3FU) : byte);
    if (two) ++i;
  }
  return units;
}

TEST(TextGrid, ReadsShortAndLongTextAlike) {
  EXPECT_EQ(parse_labels(kLong, "a.TextGrid"), expected());
  EXPECT_EQ(parse_labels(kShort, "a.textgrid"), expected());
}

TEST(TextGrid, ReadsTheOldShortHeading) {
  const auto old = replaced(
      replaced(
          std::string{kShort}, "File type = \"ooTextFile\"", "File type = \"ooTextFile short\""),
      "Object class = ",
      "");
  EXPECT_EQ(parse_labels(old, "a.TextGrid"), expected());
}

TEST(TextGrid, ReadsEveryEncodingAndLineEndAlike) {
  for (const std::string_view unix : {kLong, kShort}) {
    for (const auto* const line_end : {"\n", "\r\n", "\r"}) {
      const auto text = replaced(std::string{unix}, "\n", line_end);
      const auto units = code_units(text);
      EXPECT_EQ(parse_labels("\xEF\xBB\xBF" + text, "a.TextGrid"), expected());
      EXPECT_EQ(parse_labels(text, "a.TextGrid"), expected());
      EXPECT_EQ(parse_labels(label_cases::utf16(units, true), "a.TextGrid"), expected());
      EXPECT_EQ(parse_labels(label_cases::utf16(units, false), "a.TextGrid"), expected());
      EXPECT_EQ(parse_labels(replaced(text, "\xC3\xA4", "\xE4"), "a.TextGrid"), expected());
    }
  }
}

TEST(TextGrid, ReadsCharactersBeyondTheBasicPlaneFromUtf16) {
  const std::u16string text =
      u"\"ooTextFile\" \"TextGrid\" 0 1 <exists> 1 \"IntervalTier\" \"\U0001F600\" 0 1 1 0 1 "
      u"\"\u0251\"";
  for (const bool big_endian : {false, true}) {
    const auto labels = parse_labels(label_cases::utf16(text, big_endian), "a.TextGrid");
    EXPECT_EQ(labels.tiers.at(0).name, "\xF0\x9F\x98\x80");
    EXPECT_EQ(labels.tiers.at(0).labels.at(0).text, "\xC9\x91");
  }
}

TEST(TextGrid, TakesOnlyFreeStandingValues) {
  const auto labels = parse_labels(
      R"(File type = "ooTextFile" ! "a comment" 12
Object class = "TextGrid" of version2 [3] (4)
from 0 s to 1.5 seconds
<exists> these 1 tiers:
"IntervalTier" named "words" ! 7
0 1.5 2 intervals
from 0 to 0.5 "one
two"! 9
from 0.5 to 1.5 "three")",
      "a.TextGrid");
  EXPECT_EQ(labels,
            (Labels{.end = 1500ms,
                    .tiers = {{.name = "words",
                               .labels = {{0ms, 500ms, "one\ntwo"}, {500ms, 1500ms, "three"}}}}}));
}

TEST(TextGrid, ReadsGridsWithoutTiersOrLabels) {
  EXPECT_EQ(parse_labels("\"ooTextFile\" \"TextGrid\" 0 2 <absent>", "a.TextGrid"),
            (Labels{.end = 2s, .tiers = {}}));
  EXPECT_EQ(parse_labels("\"ooTextFile\" \"TextGrid\" 0 2 <exists> 0", "a.TextGrid"),
            (Labels{.end = 2s, .tiers = {}}));
  EXPECT_EQ(parse_labels("\"ooTextFile\" \"TextGrid\" 0 2 <exists> 1 \"TextTier\" \"p\" 0 2 0",
                         "a.TextGrid"),
            (Labels{.end = 2s, .tiers = {{.name = "p", .labels = {}}}}));
}

TEST(TextGrid, MovesBoundariesThatOverlapByRounding) {
  const auto grid = [](const std::string& start) {
    return "\"ooTextFile\" \"TextGrid\" 0 2 <exists> 1 \"IntervalTier\" \"p\" 0 2 2\n0 1.0000007 "
           "\"a\"\n" +
           start + " 2.0000004 \"b\"";
  };
  EXPECT_EQ(parse_labels(grid("1"), "a.TextGrid").tiers.at(0).labels.at(1),
            (Label{1'000'000'700ns, 2s, "b"}));
  EXPECT_THAT(fault_of(grid("0.99999"), "a.TextGrid"),
              AllOf(HasSubstr("a.TextGrid:3"), HasSubstr("before the end of the one before it")));
}

TEST(TextGrid, WritesWhatTheFormatSays) {
  const WrittenFiles folder;
  const auto file = folder / "b.TextGrid";
  write_labels(file,
               {.end = 2s,
                .tiers = {{.name = "w", .labels = {{250ms, 1s, "say \"hi\""}}},
                          {.name = "p", .labels = {{1ns, 1ns, "x"}}}}});
  EXPECT_EQ(read_file(file), R"(File type = "ooTextFile"
Object class = "TextGrid"

xmin = 0.0
xmax = 2.0
tiers? <exists>
size = 2
item []:
    item [1]:
        class = "IntervalTier"
        name = "w"
        xmin = 0.0
        xmax = 2.0
        intervals: size = 3
        intervals [1]:
            xmin = 0.0
            xmax = 0.25
            text = ""
        intervals [2]:
            xmin = 0.25
            xmax = 1.0
            text = "say ""hi"""
        intervals [3]:
            xmin = 1.0
            xmax = 2.0
            text = ""
    item [2]:
        class = "TextTier"
        name = "p"
        xmin = 0.0
        xmax = 2.0
        points: size = 1
        points [1]:
            number = 0.000000001
            mark = "x"
)");
}

TEST(TextGrid, RefusesOtherFormsOfPraatWithTheWayOut) {
  EXPECT_EQ(
      fault_of("\"Praat chronological TextGrid text file\"\n0 1.5\n", "c.TextGrid"),
      "c.TextGrid:1: this is a chronological TextGrid; in Praat, choose 'Save as text file...'");
  EXPECT_EQ(fault_of(std::string_view{"ooBinaryFile\x08TextGrid\0\0", 23}, "c.TextGrid"),
            "c.TextGrid: this is a binary Praat file; in Praat, choose 'Save as text file...'");
  EXPECT_THAT(fault_of("File type = \"ooTextFile\"\nObject class = \"Pitch 1\"\n", "c.TextGrid"),
              AllOf(HasSubstr("c.TextGrid:2: this is a Praat Pitch 1, not a TextGrid"),
                    HasSubstr("'Save as text file...'")));
}

TEST(TextGrid, RefusesWhatIsWrongWithItsLine) {
  const std::string grid{kLong};
  const auto fault = [&](std::string_view what, std::string_view by) {
    return fault_of(replaced(grid, what, by), "d.TextGrid");
  };
  EXPECT_THAT(fault("xmax = 0.75", "xmax = 0.7.5"),
              HasSubstr("d.TextGrid:21: \"0.7.5\" is not a time"));
  EXPECT_THAT(fault("xmax = 0.75", "xmax = x"), HasSubstr("d.TextGrid:22: \"\"say"));
  EXPECT_THAT(fault("xmax = 0.75", "xmax = 0.25"),
              HasSubstr("d.TextGrid:21: the label \"say \"hi\"\" begins at 0.5 s and ends before"));
  EXPECT_THAT(fault("xmin = 0.5", "xmin = -0.5"),
              HasSubstr("d.TextGrid:20: the time \"-0.5\" is negative"));
  EXPECT_THAT(fault("xmin = 0.5", "xmin = 1e400"), HasSubstr("d.TextGrid:20: "));
  EXPECT_THAT(fault("xmin = 0.5", "xmin = 1e7"), HasSubstr("beyond 1000000 s"));
  EXPECT_THAT(fault("xmin = 0.5", "xmin = --undefined--"), HasSubstr("d.TextGrid:20: "));
  EXPECT_THAT(fault("size = 3", "size = -3"), HasSubstr("d.TextGrid:14: \"-3\" is not the number"));
  EXPECT_THAT(fault("size = 3", "size = 2"), HasSubstr("d.TextGrid:24: "));
  EXPECT_THAT(fault("points: size = 1", "points: size = 0"),
              HasSubstr("d.TextGrid:34: there is more behind the last tier"));
  EXPECT_THAT(fault("points: size = 1", "points: size = 99999999999"),
              HasSubstr("the file ends where the time of a point should be"));
  EXPECT_THAT(fault("\"TextTier\"", "\"TextTiger\""),
              HasSubstr("d.TextGrid:28: \"TextTiger\" is not the class of a tier"));
  EXPECT_THAT(fault("\"click\"", "\"cl\"ick\""),
              HasSubstr("d.TextGrid:35: \"cl\" goes on behind its quotation mark"));
  EXPECT_THAT(fault("\"click\"", "\"click"), HasSubstr("d.TextGrid:35: the text that begins here"));
  EXPECT_THAT(fault("number = 0.25", "number = 1.75"),
              HasSubstr("d.TextGrid:34: the label ends at 1.75 s, beyond the end"));
  EXPECT_THAT(fault("<exists>", "<exists"), HasSubstr("d.TextGrid:6: \"<exists\" lacks its"));
  EXPECT_THAT(fault_of("", "d.TextGrid"), HasSubstr("d.TextGrid:1: the file ends where"));
  EXPECT_THAT(fault_of("0 1 sil\n", "d.TextGrid"), HasSubstr("d.TextGrid:1: "));
}

TEST(TextGrid, RefusesBrokenEncodingsWithTheirLine) {
  EXPECT_THAT(fault_of(std::string_view{"a\nb\0c", 5}, "e.TextGrid"),
              HasSubstr("e.TextGrid:2: a NUL character"));
  EXPECT_THAT(fault_of(label_cases::utf16(u"a\n\nb", false) + "c", "e.TextGrid"),
              HasSubstr("e.TextGrid:3: the file is UTF-16 and ends within a character"));
  const char16_t lone = 0xDC00;
  EXPECT_THAT(fault_of(label_cases::utf16(std::u16string{u"a\n"} + lone, true), "e.TextGrid"),
              HasSubstr("e.TextGrid:2: half of a UTF-16 surrogate pair"));
  const char16_t high = 0xD83D;
  EXPECT_THAT(fault_of(label_cases::utf16(std::u16string{u"a\n"} + high, true), "e.TextGrid"),
              HasSubstr("e.TextGrid:2: half of a UTF-16 surrogate pair"));
}

}  // namespace
}  // namespace bimodal

#include "stimuli/base/csv_reader.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/csv.hpp"
#include "stimuli/base/random.hpp"
#include "tests/support/fault_of.hpp"

namespace bimodal {
namespace {

using testing::HasSubstr;

using Table = std::vector<std::vector<std::string>>;

Table table_in(std::string_view text) {
  CsvReader csv{text, "f.csv"};
  Table table;
  while (auto fields = csv.next()) table.push_back(std::move(*fields));
  return table;
}

std::string fault_in(std::string_view text) {
  return fault_of([&] { return table_in(text); });
}

TEST(CsvReader, TakesFieldsAsTheyAreWritten) {
  EXPECT_EQ(table_in("a,NA,\n\"x, \"\"y\"\"\nz\", 1 ,b\n"),
            (Table{{"a", "NA", ""}, {"x, \"y\"\nz", " 1 ", "b"}}));
}

TEST(CsvReader, TakesLinesOfWindowsAMarkAtTheBeginningAndALineWithoutAnEnd) {
  EXPECT_EQ(table_in("\xef\xbb\xbf"
                     "a,b\r\n\r\n\"c\r\nd\",e"),
            (Table{{"a", "b"}, {"c\r\nd", "e"}}));
  EXPECT_EQ(table_in(""), Table{});
  EXPECT_EQ(table_in("\r\n\n"), Table{});
  EXPECT_EQ(table_in("a,"), (Table{{"a", ""}}));
}

TEST(CsvReader, TellsTheLineOfARecordAfterQuotedLineBreaks) {
  CsvReader csv{"\"a\n\nb\",1\n\nc,2\n", "f.csv"};
  static_cast<void>(csv.next());
  EXPECT_EQ(csv.line(), 1U);
  static_cast<void>(csv.next());
  EXPECT_EQ(csv.line(), 5U);
}

TEST(CsvReader, NamesTheLineOfAMistake) {
  EXPECT_THAT(fault_in("a\nb\"c\n"), HasSubstr("f.csv:2: a quotation mark within"));
  EXPECT_THAT(fault_in("a\nb\rc\n"), HasSubstr("f.csv:2: a lone carriage return"));
  EXPECT_THAT(fault_in("\"a\n\"b\n"), HasSubstr("f.csv:2: \"a\n\" goes on behind"));
  EXPECT_THAT(fault_in("a\n\n\"b\n\n"), HasSubstr("f.csv:3: the quoted field that begins here"));
  EXPECT_THAT(fault_in(std::string(1'000, ',')), HasSubstr("f.csv:1: more than 1000 fields"));
}

TEST(CsvReader, ReadsBackWhateverWasWritten) {
  Random random{7};
  constexpr std::string_view kLetters = "a,\"\r\n \xc3\xbc";
  for (int round = 0; round < 2'000; ++round) {
    std::vector<std::string> fields(1 + random.below(4));
    fields.front() = "x";  // an empty line would be no record
    std::string text;
    for (auto& field : fields) {
      for (auto left = random.below(5); left > 0; --left) {
        field += kLetters[random.below(kLetters.size())];
      }
      text += (text.empty() ? "" : ",") + csv_field(field);
    }
    EXPECT_EQ(table_in(text + "\r\n"), Table{fields}) << text;
  }
}

TEST(CsvReader, EndsOnWhateverBytes) {
  Random random{11};
  for (int round = 0; round < 20'000; ++round) {
    std::string text;
    for (auto left = random.below(12); left > 0; --left)
      text += "a,\"\r\n\xef\xbb\xbf"[random.below(8)];
    static_cast<void>(fault_in(text));
  }
}

}  // namespace
}  // namespace bimodal

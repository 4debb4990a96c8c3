#include "stimuli/base/json_lines.hpp"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stimuli/base/random.hpp"

namespace bimodal {
namespace {

TEST(PositionOf, CountsLinesAndCharactersFromOne) {
  const std::string text = "ab\n\xC3\xA9x\r\ny";
  EXPECT_EQ(position_of(text, 0), (TextPosition{1, 1}));
  EXPECT_EQ(position_of(text, 2), (TextPosition{1, 3}));
  EXPECT_EQ(position_of(text, 3), (TextPosition{2, 1}));
  EXPECT_EQ(position_of(text, 5), (TextPosition{2, 2}));  // behind the two bytes of e acute
  EXPECT_EQ(position_of(text, 8), (TextPosition{3, 1}));
  EXPECT_EQ(position_of(text, 1'000), (TextPosition{3, 2}));
  EXPECT_EQ(position_of("\xEF\xBB\xBFx", 3), (TextPosition{1, 1}));
}

TEST(JsonLines, KnowsTheLineOfEveryValue) {
  const JsonLines lines{
      "\n{ \"a\": 1,\n"
      "  \"b\":\n [10,\n {\"c\": null},\n []  ,{}\n],\n"
      "\"d/e~f\" : \"x\\\"\\\\\",\n"
      "\"\\u0067\" : -1.5e3 }\n"};
  EXPECT_EQ(lines.line_of(""), 2U);
  EXPECT_EQ(lines.line_of("/a"), 2U);
  EXPECT_EQ(lines.line_of("/b"), 3U);  // where its key is
  EXPECT_EQ(lines.line_of("/b/0"), 4U);
  EXPECT_EQ(lines.line_of("/b/1"), 5U);
  EXPECT_EQ(lines.line_of("/b/1/c"), 5U);
  EXPECT_EQ(lines.line_of("/b/2"), 6U);
  EXPECT_EQ(lines.line_of("/b/3"), 6U);
  EXPECT_EQ(lines.line_of("/d~1e~0f"), 8U);
  EXPECT_EQ(lines.line_of("/g"), 9U);
  EXPECT_TRUE(lines.duplicates().empty());
}

TEST(JsonLines, GivesTheLineOfTheEnclosingValueForWhatIsMissing) {
  const JsonLines lines{"{\n\"a\": [\n1]}"};
  EXPECT_EQ(lines.line_of("/zzz"), 1U);
  EXPECT_EQ(lines.line_of("/a/7/x"), 2U);
}

TEST(JsonLines, FindsKeysThatAreGivenTwice) {
  const JsonLines lines{
      "{\"a\": [{\n\"x\": 1,\n\"y\": 2,\n\"\\u0078\": 3}],\n\"a/\": {}, \"b\": 1}"};
  ASSERT_EQ(lines.duplicates().size(), 1U);
  EXPECT_EQ(lines.duplicates()[0].pointer, "/a/0/x");
  EXPECT_EQ(lines.duplicates()[0].earlier_line, 2U);
  EXPECT_EQ(lines.duplicates()[0].line, 4U);
  EXPECT_EQ(lines.line_of("/a/0/x"), 4U);
}

/// A random JSON value; every array and object holds at most three items.
nlohmann::json random_value(Random& random, int depth) {
  auto value = nlohmann::json::array();
  switch (random.below(depth > 0 ? 6 : 4)) {
    case 0:
      return nullptr;
    case 1:
      return random.normal();
    case 2:
      return "a\"{[,]}:\n\\";
    case 3:
      return random.below(2) == 0;
    case 4:
      for (auto n = random.below(4); n > 0; --n) value.push_back(random_value(random, depth - 1));
      return value;
    default:
      value = nlohmann::json::object();
      for (auto n = random.below(4); n > 0; --n) {
        const std::string key{"x/~\"\n", random.below(6)};
        value[key] = random_value(random, depth - 1);
      }
      return value;
  }
}

// In nlohmann's pretty print every item of a non-empty array or object begins a line of its own, in
// order; so the lines of a walk through the values are known without scanning.
void expect_lines(const nlohmann::json& value,
                  const std::string& pointer,
                  const JsonLines& lines,
                  std::size_t& line) {
  EXPECT_EQ(lines.line_of(pointer), line) << pointer;
  if (!value.is_structured() || value.empty()) return;
  std::size_t index = 0;
  for (const auto& [key, item] : value.items()) {
    ++line;
    const auto part = value.is_array() ? std::to_string(index++) : escape_pointer(key);
    expect_lines(item, pointer + "/" + part, lines, line);
  }
  ++line;  // the closing bracket
}

TEST(JsonLines, AgreesWithThePrinterOnAnyValue) {
  Random random{5};
  for (int i = 0; i < 500; ++i) {
    const auto value = random_value(random, 5);
    const auto text = value.dump(2);
    const JsonLines lines{text};
    std::size_t line = 1;
    expect_lines(value, "", lines, line);
    EXPECT_TRUE(lines.duplicates().empty());
  }
}

}  // namespace
}  // namespace bimodal

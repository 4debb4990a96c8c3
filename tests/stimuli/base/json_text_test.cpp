#include "stimuli/base/json_text.hpp"

#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bimodal {
namespace {

using ::testing::HasSubstr;
using namespace std::string_literals;

TextFault fault_of(std::string_view text) {
  const auto parsed = parse_json(text);
  const auto* fault = std::get_if<TextFault>(&parsed);
  if (fault == nullptr) {
    ADD_FAILURE() << "was accepted: " << text.substr(0, 80);
    return {};
  }
  return *fault;
}

TEST(ParseJson, TakesJson) {
  const auto parsed = parse_json("\xEF\xBB\xBF{\"a\": [1, \"\xF0\x9F\x99\x82\"]}\r\n");
  ASSERT_TRUE(std::holds_alternative<nlohmann::json>(parsed));
  EXPECT_EQ(std::get<nlohmann::json>(parsed)["a"][0], 1);
}

TEST(ParseJson, SaysLineColumnAndRemedyOfASyntaxError) {
  const auto comma = fault_of("{\n  \"a\": 1,\n}");
  EXPECT_EQ(comma.line, 3U);
  EXPECT_THAT(comma.finding, HasSubstr("not JSON: column 1: "));
  EXPECT_THAT(comma.finding, HasSubstr("unexpected '}'"));
  EXPECT_THAT(comma.remedy, HasSubstr("remove the comma"));

  const auto missing = fault_of("{\n  \"a\": 1\n  \"b\": 2}");
  EXPECT_EQ(missing.line, 3U);
  EXPECT_THAT(missing.remedy, HasSubstr("a comma is missing"));

  EXPECT_THAT(fault_of("{\"a\": 1 // one\n}").remedy, HasSubstr("no comments"));
  EXPECT_THAT(fault_of("{\"a\": [1, 2").remedy, HasSubstr("closing bracket"));
  EXPECT_EQ(fault_of("experiment: 1").line, 1U);
}

TEST(ParseJson, RefusesAnEmptyFile) {
  EXPECT_EQ(fault_of("").finding, "the file is empty");
  EXPECT_EQ(fault_of(" \n\t\n").finding, "the file is empty");
}

TEST(ParseJson, RefusesWhatIsNotUtf8) {
  for (const auto& bytes : {"\xFF"s,
                            "\xC0\x80"s,
                            "\xED\xA0\x80"s,
                            "\xF4\x90\x80\x80"s,
                            "\xE2\x82"s,
                            "\x80"s,
                            "\xF0\x80\x80\x80"s}) {
    const auto fault = fault_of("{\n\"a\": \"" + bytes + "\"}");
    EXPECT_EQ(fault.line, 2U);
    EXPECT_THAT(fault.finding, HasSubstr("at column 7 is not UTF-8"));
  }
  EXPECT_THAT(fault_of("{\"a\": \"\xE2\x82").finding, HasSubstr("is not UTF-8"));
  EXPECT_THAT(fault_of("\xFF\xFE{\0}\0"s).finding, HasSubstr("UTF-16"));
  EXPECT_THAT(fault_of("{\"a\": 1}\n\0"s).finding, HasSubstr("NUL"));
}

TEST(ParseJson, RefusesWhatCostsTooMuch) {
  EXPECT_THAT(fault_of(std::string(kLargestFile + 1, ' ')).finding, HasSubstr("16 MB"));
  const std::string deep(100'000, '[');
  EXPECT_THAT(fault_of("{\n\"a\": " + deep).finding, HasSubstr("more than 64"));
  EXPECT_EQ(fault_of("{\n\"a\": " + deep).line, 2U);
  std::string many = "[";
  for (std::size_t i = 0; i < kMostValues; ++i) many += "1,";
  EXPECT_THAT(fault_of(many + "1]").finding, HasSubstr("more than 200000 values"));
}

TEST(ParseJson, TakesWhatIsJustNotTooDeep) {
  const auto text = std::string(kDeepestNesting, '[') + std::string(kDeepestNesting, ']');
  EXPECT_TRUE(std::holds_alternative<nlohmann::json>(parse_json(text)));
  EXPECT_TRUE(
      std::holds_alternative<nlohmann::json>(parse_json("\"" + std::string(200, '[') + "\"")));
}

TEST(ParseJson, RefusesNumbersBeyondADouble) {
  const auto fault = fault_of("{\n\n\"seed\": 1e999}");
  EXPECT_EQ(fault.line, 3U);
  EXPECT_EQ(fault.finding, "the number 1e999 is too large");
}

TEST(ParseJson, NeverRepeatsALongTokenInItsMessage) {
  EXPECT_LT(fault_of("{\"a\": \"" + std::string(1'000'000, 'x')).finding.size(), 300U);
  EXPECT_LT(fault_of("[" + std::string(1'000'000, '9') + "]").finding.size(), 300U);
  EXPECT_LT(fault_of("[\"" + std::string(1'000'000, 'x') + "\" 1]").finding.size(), 300U);
}

TEST(Shown, ShortensAndEscapes) {
  EXPECT_EQ(shown("loud"), "\"loud\"");
  EXPECT_EQ(shown(-8.5), "-8.5");
  EXPECT_EQ(shown("a\x1b[2J\n"), "\"a\\u001b[2J\\n\"");
  EXPECT_EQ(shown({{"a", 1}}), "{...}");
  EXPECT_EQ(shown(nlohmann::json::array()), "[]");
  const auto text = shown(std::string(59, 'x') + "\xC3\xA9" + std::string(100, 'y'));
  EXPECT_EQ(text, "\"" + std::string(59, 'x') + "...\"");
}

}  // namespace
}  // namespace bimodal

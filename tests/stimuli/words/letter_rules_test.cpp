#include "stimuli/words/letter_rules.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/random.hpp"

namespace bimodal {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string shipped() {
  return read_file(asset("stimuli/assets/words/nrl-rules.tsv"));
}

/// One rule without contexts for each letter and digit.
std::string last_resorts() {
  std::string rules;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    rules += fmt::format("{0}\t1\t\t{0}\t\t/T/\n", letter);
  }
  for (int digit = 0; digit <= 9; ++digit) {
    rules += fmt::format("NUMBER\t{}\t\t{}\t\t/T/\n", digit + 1, digit);
  }
  return rules;
}

std::string with_header(std::string_view rules) {
  return fmt::format("group\tindex\tleft\ttext\tright\tphonemes\n{}", rules);
}

std::string message_about(std::string_view content) {
  try {
    (void)parse_letter_rules(content, "x.tsv");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::string message_about_rule(std::string_view rule) {
  return message_about(with_header(last_resorts() + std::string{rule}));
}

TEST(LetterRules, AreThe329OfTheReport) {
  const auto rules = parse_letter_rules(shipped(), "nrl-rules.tsv");
  EXPECT_EQ(rules.size(), 329U);
  std::map<std::string, int> counts;
  for (const auto& rule : rules)
    ++counts[rule.name.substr(0, rule.name.find_first_of("0123456789"))];
  const std::map<std::string, int> expected{
      {"A", 33}, {"B", 6},  {"C", 11}, {"D", 10}, {"E", 35}, {"F", 2},      {"G", 10},
      {"H", 6},  {"I", 28}, {"J", 1},  {"K", 2},  {"L", 5},  {"M", 2},      {"N", 8},
      {"O", 48}, {"P", 5},  {"Q", 3},  {"R", 2},  {"S", 23}, {"T", 26},     {"U", 15},
      {"V", 2},  {"W", 12}, {"X", 1},  {"Y", 11}, {"Z", 1},  {"PUNCT", 11}, {"NUMBER", 10}};
  EXPECT_EQ(counts, expected);
}

TEST(LetterRules, KeepTheBlanksOfContextsAndCallTheReportsNxNg) {
  const auto rules = parse_letter_rules(shipped(), "nrl-rules.tsv");
  const auto named = [&](std::string_view name) {
    return *std::ranges::find(rules, name, &LetterRule::name);
  };
  EXPECT_EQ(named("A2").left, " ");
  EXPECT_EQ(named("A2").right, " ");
  EXPECT_THAT(named("A2").phones, ElementsAre(Phone::AA, Phone::R));
  EXPECT_EQ(named("D3").left, "E:^#") << "nearest first";
  EXPECT_THAT(named("N5").phones, ElementsAre(Phone::NG));
  EXPECT_TRUE(named("E1").phones.empty());
  EXPECT_EQ(named("E1").ends, std::nullopt);
  EXPECT_EQ(named("PUNCT3").ends, Pause::None);
  EXPECT_EQ(named("PUNCT9").ends, Pause::Comma);
}

TEST(LetterRules, NameTheLineOfAMistake) {
  EXPECT_THAT(message_about("letters\n"), StartsWith("x.tsv:1: the first line does not name"));
  EXPECT_THAT(message_about_rule("A\t2\t\tAB\t/T/\n"), StartsWith("x.tsv:38: there are not six"));
  EXPECT_THAT(message_about_rule("\n"), StartsWith("x.tsv:38: there are not six"));
  EXPECT_THAT(message_about_rule("A\t2\t\tab\t\t/T/\n"), HasSubstr("x.tsv:38: \"ab\" is no text"));
  EXPECT_THAT(message_about_rule("A\t2\t\t\t\t/T/\n"), HasSubstr("\"\" is no text"));
  EXPECT_THAT(message_about_rule("B\t2\t\tAB\t\t/T/\n"), HasSubstr("put it into group A"));
  EXPECT_THAT(message_about_rule("A\t2\tx\tAB\t\t/T/\n"), HasSubstr("\"x\" is no context"));
  EXPECT_THAT(message_about_rule("A\t2\t\tAB\t!\t/T/\n"), HasSubstr("\"!\" is no context"));
  EXPECT_THAT(message_about_rule("A\t3\t\tAB\t\t/T/\n"), HasSubstr("\"3\" in place 2 of group A"));
  EXPECT_THAT(message_about_rule("A\t2\t\tAB\t\tT\n"), HasSubstr("between slashes"));
  EXPECT_THAT(message_about_rule("A\t2\t\tAB\t\t/QQ/\n"), HasSubstr("\"QQ\" is not a phone"));
  EXPECT_THAT(message_about_rule("A\t2\t\tAB\t\t/rest/\n"), HasSubstr("\"rest\" is not a phone"));
}

TEST(LetterRules, TellEveryMistakeAtOnce) {
  EXPECT_THAT(message_about_rule("A\t2\t\tAB\t\t/T/\nA\t3\t\tab\t\t/T/\nB\t2\t\tB\t\t/QQ/\n"),
              AllOf(HasSubstr("x.tsv:39:"), HasSubstr("\nx.tsv:40:"), Not(HasSubstr("x.tsv:38:"))));
}

TEST(LetterRules, LeaveNoLetterOrDigitUnreadable) {
  EXPECT_EQ(message_about(with_header(last_resorts())), "no error");
  EXPECT_EQ(message_about_rule("A\t2\t\tAB\t\t/T/\r\n"), "no error");
  auto rules = last_resorts();
  rules.erase(rules.find("Q\t1"), rules.find("R\t1") - rules.find("Q\t1"));
  EXPECT_THAT(message_about(with_header(rules)),
              StartsWith("x.tsv: there is no rule without contexts for Q;"));
  EXPECT_THAT(message_about(""), EndsWith("end the group of every letter and digit with one"));
}

TEST(LetterRules, DamagedFilesAreRulesOrErrorsWithTheFilesName) {
  const auto whole = shipped();
  constexpr int kMutations = 2'000;
  Random random{19'760'101};
  int accepted = 0;
  for (int i = 0; i < kMutations; ++i) {
    auto content = whole;
    for (auto times = 1 + random.below(3); times > 0; --times) {
      const auto at = random.below(content.size());
      const auto length = 1 + random.below(40);
      switch (random.below(4)) {
        case 0:
          content.at(at) = static_cast<char>(random.below(256));
          break;
        case 1:
          content.erase(at, length);
          break;
        case 2:
          content.insert(random.below(content.size()), content.substr(at, length));
          break;
        default:
          content.at(at) = "\t\n /#:%'"[random.below(8)];
          break;
      }
    }
    try {
      for (const auto& rule : parse_letter_rules(content, "x.tsv"))
        ASSERT_FALSE(rule.letters.empty());
      ++accepted;
    } catch (const Error& error) {
      ASSERT_THAT(error.what(), StartsWith("x.tsv:"));
    }
  }
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, kMutations);
}

}  // namespace
}  // namespace bimodal

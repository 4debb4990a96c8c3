#include "analysis/cli/command_line.hpp"

#include <gtest/gtest.h>

#include "tests/analysis/report/figure_examples.hpp"

namespace bimodal::analysis {
namespace {

TEST(CommandLine, LeavesPlainWordsAlone) {
  const std::vector<std::string> words{"report", "a/b-1.sqlite", "--at-least", "auditory=0.2"};
  EXPECT_EQ(command_line("p", words), "p report a/b-1.sqlite --at-least auditory=0.2");
}

// The shell itself is the judge.
TEST(CommandLine, IsReadByAShellAsItWas) {
  const std::vector<std::string> words{"%s|", "it's", "a  b", "", "$HOME", "\"q\"", "*", "\\"};
  EXPECT_EQ(examples::printed_by(command_line("printf", words)), "it's|a  b||$HOME|\"q\"|*|\\|");
}

}  // namespace
}  // namespace bimodal::analysis

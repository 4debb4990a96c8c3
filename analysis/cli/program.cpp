#include "analysis/cli/program.hpp"

#include <algorithm>
#include <exception>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/cli/verb.hpp"
#include "runner/store/store_error.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/nearest.hpp"

namespace bimodal::analysis {

namespace {

constexpr const char* kExamples = R"(Examples:
  bimodal-analysis score session.sqlite
  bimodal-analysis report session.sqlite -o report
  bimodal-analysis report P01.sqlite P02.sqlite -o report --exclude-flagged
  bimodal-analysis matrix session.sqlite --unit vowel --condition visual
  bimodal-analysis information m.csv --features f.csv
  bimodal-analysis export m.csv --format praat -o m.Confusion
  bimodal-analysis matrix --help

Exit codes: 0 done, 1 nothing to analyse, 2 wrong usage, 3 invalid input,
5 a data file cannot be read, 70 an error in this program.)";

/// What is wrong with the first word, if it is no verb; else empty.
std::string unknown_verb(const CLI::App& program, std::span<const std::string> arguments) {
  if (arguments.empty() || arguments.front().starts_with('-')) return {};
  std::vector<std::string> names;
  for (const auto* const verb : program.get_subcommands({})) names.push_back(verb->get_name());
  if (std::ranges::find(names, arguments.front()) != names.end()) return {};
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto meant = nearest(arguments.front(), known);
  return fmt::format("there is no verb \"{}\"{}; the verbs are: {}",
                     arguments.front(),
                     meant ? fmt::format(", did you mean {}?", *meant) : std::string{},
                     fmt::join(names, ", "));
}

/// "did you mean --seed instead of --sed?", of the first option that the verb does not have and
/// that is near one that it has; else empty.
std::string misspelt_option(const CLI::App& program, std::span<const std::string> arguments) {
  const auto verbs = program.get_subcommands();  // those that were named
  if (verbs.empty()) return {};
  std::vector<std::string> names;
  for (const auto* const option : verbs.front()->get_options()) {
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  for (const auto& argument : arguments) {
    const auto typed = argument.substr(0, argument.find('='));
    if (!typed.starts_with("--") || std::ranges::find(names, typed) != names.end()) continue;
    if (const auto meant = nearest(typed, known)) {
      return fmt::format("did you mean {} instead of {}?", *meant, typed);
    }
  }
  return {};
}

ExitCode parse_and_run(std::span<const std::string> arguments, Console console) {
  CLI::App program{"What the stored sessions of bimodal mean: scores, confusion matrices, reports.",
                   "bimodal-analysis"};
  program.footer(kExamples);
  program.require_subcommand(1);
  program.set_version_flag("--version",
                           std::string{"bimodal-analysis "} + std::string{program_version()});
  Verb chosen;
  add_score_verb(program, chosen);
  add_report_verb(program, chosen, arguments);
  add_matrix_verb(program, chosen);
  add_information_verb(program, chosen);
  add_sinfa_verb(program, chosen);
  add_cluster_verb(program, chosen);
  add_mds_verb(program, chosen);
  add_proportions_verb(program, chosen);
  add_compare_verb(program, chosen);
  add_export_verb(program, chosen);
  if (const auto unknown = unknown_verb(program, arguments); !unknown.empty()) {
    console.err << "bimodal-analysis: " << unknown << '\n';
    return ExitCode::Usage;
  }
  try {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // as CLI11 wants them
    program.parse(std::move(reversed));
  } catch (const CLI::ParseError& error) {
    if (program.exit(error, console.out, console.err) == 0) return ExitCode::Done;
    const auto hint = misspelt_option(program, arguments);
    if (!hint.empty()) console.err << "bimodal-analysis: " << hint << '\n';
    return ExitCode::Usage;
  }
  return chosen(console);
}

}  // namespace

ExitCode run_program(std::span<const std::string> arguments, Console console) noexcept {
  const auto complain = [&](const std::exception& error, ExitCode code) {
    console.err << "bimodal-analysis: " << describe(error) << '\n';
    return code;
  };
  try {
    try {
      return parse_and_run(arguments, console);
    } catch (const runner::StoreError& error) {
      return complain(error, ExitCode::Store);
    } catch (const Error& error) {
      return complain(error, ExitCode::InvalidInput);
    } catch (const std::exception& error) {
      return complain(error, ExitCode::Internal);
    }
  } catch (...) {
    return ExitCode::Internal;
  }
}

}  // namespace bimodal::analysis

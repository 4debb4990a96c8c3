#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "runner/cli/option_checks.hpp"
#include "runner/cli/verbs.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/labels/label_file.hpp"

namespace bimodal::runner {

namespace {

struct LabelsOptions {
  std::string input;
  std::string output;  ///< empty: only tell
  std::string tier;    ///< empty: all
  bool phones = false;
};

double seconds(Duration time) {
  return std::chrono::duration<double>{time}.count();
}

std::string names_of(const Labels& labels) {
  std::string names;
  for (const auto& tier : labels.tiers) {
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", tier.name);
  }
  return names.empty() ? "it has no tiers" : "it has " + names;
}

const Tier& tier_named(const Labels& labels, const LabelsOptions& options) {
  const auto found = std::ranges::find(labels.tiers, options.tier, &Tier::name);
  if (found == labels.tiers.end()) {
    throw Error{fmt::format(
        "{}: there is no tier \"{}\"; {}", options.input, options.tier, names_of(labels))};
  }
  return *found;
}

const Tier& phones_of(const Labels& labels, const LabelsOptions& options) {
  if (!options.tier.empty()) return labels.tiers.front();
  const auto* const tier = phone_tier(labels);
  if (tier == nullptr) {
    throw Error{fmt::format("{}: no tier is named \"phones\" or the like; {}; choose by --tier",
                            options.input,
                            names_of(labels))};
  }
  return *tier;
}

/// What the file has of what was asked for.
Labels chosen_labels(const LabelsOptions& options) {
  auto labels = read_labels(options.input);
  if (!options.tier.empty()) {
    auto tier = tier_named(labels, options);
    labels.tiers = {std::move(tier)};
  }
  return labels;
}

std::string described(const Label& label) {
  return fmt::format(
      "{:.3f}-{:.3f} s \"{}\"", seconds(label.start), seconds(label.end), label.text);
}

void print_table(const Labels& labels, const std::string& file) {
  fmt::print("{}: {:.3f} s, {}\n", file, seconds(labels.end), counted(labels.tiers.size(), "tier"));
  if (labels.tiers.empty()) return;
  fmt::print("  {:<12} {:>6}  {:<28} {}\n", "tier", "labels", "first", "last");
  for (const auto& tier : labels.tiers) {
    const bool none = tier.labels.empty();
    fmt::print("  {:<12} {:>6}  {:<28} {}\n",
               tier.name,
               tier.labels.size(),
               none ? "" : described(tier.labels.front()),
               none ? "" : described(tier.labels.back()));
  }
}

/// All labels that are no phones, each with its time.
ExitCode judge_phones(const Tier& tier) {
  const auto unknown = not_phones(tier);
  if (unknown.empty()) {
    fmt::print("every label of \"{}\" is a known phone\n", tier.name);
    return ExitCode::Done;
  }
  fmt::print("{} of \"{}\" {} not known as phones:\n",
             counted(unknown.size(), "label"),
             tier.name,
             unknown.size() == 1 ? "is" : "are");
  for (const auto& label : unknown) fmt::print("  {}\n", described(label));
  return ExitCode::Findings;
}

ExitCode tell(const LabelsOptions& options) {
  const auto labels = chosen_labels(options);
  print_table(labels, options.input);
  if (options.phones) return judge_phones(phones_of(labels, options));
  const auto* const tier = phone_tier(labels);
  return tier == nullptr ? ExitCode::Done : judge_phones(*tier);
}

ExitCode convert(const LabelsOptions& options) {
  auto labels = chosen_labels(options);
  if (options.phones) labels = labels_of(utterance_of(phones_of(labels, options), labels.end));
  if (labels.tiers.size() > 1 && holds_one_tier(options.output)) {
    throw Error{
        fmt::format("cannot write '{}': it can hold one tier and '{}' has {}; {}; choose by "
                    "--tier, or write a TextGrid",
                    options.output,
                    options.input,
                    labels.tiers.size(),
                    names_of(labels))};
  }
  write_labels(options.output, labels);
  print_table(labels, options.output);
  return ExitCode::Done;
}

}  // namespace

void add_labels(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "labels",
      "Shows what stands in a file of labels, or converts it: Praat TextGrids (.TextGrid), HTK "
      "and\n"
      "Festival (.lab), GRID (.align), tables (.csv). Without -o, prints a table of the tiers, "
      "and\n"
      "which labels of a tier of phones are no phones.\n"
      "Exit code: 0 done, 1 labels that are no phones, 3 errors.\n\n"
      "Examples:\n"
      "  bimodal labels bbaf2n.align                            what is in it?\n"
      "  bimodal labels bbaf2n.align -o bbaf2n.TextGrid         to look at it in Praat\n"
      "  bimodal labels cat.TextGrid --tier words -o cat.lab    one tier, for HTK\n"
      "  bimodal labels cat.lab --phones -o cat.TextGrid        closure and release as one phone");
  auto options = std::make_shared<LabelsOptions>();
  verb->add_option("FILE", options->input, "the file of labels; its ending tells the format")
      ->required();
  verb->add_option(
          "-o,--output", options->output, "the file to be written; its ending tells the format")
      ->check(in_a_folder_that_exists());
  verb->add_option("--tier", options->tier, "only the tier of this name");
  verb->add_flag("--phones",
                 options->phones,
                 "only the tier of phones (or --tier), in ARPAbet, pauses as \"sil\"");
  verb->callback([options, &chosen] {
    chosen = [options] { return options->output.empty() ? tell(*options) : convert(*options); };
  });
}

}  // namespace bimodal::runner

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "runner/cli/option_checks.hpp"
#include "runner/cli/segments_verbs.hpp"
#include "runner/cli/text_table.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/timeline/inventory_file.hpp"
#include "stimuli/timeline/phone.hpp"
#include "synth/inspection/contact_table.hpp"

namespace bimodal::runner {

namespace {

struct ContactOptions {
  std::string file = "english";
  std::vector<double> rates{0.5, 1.0, 2.0};
  std::vector<std::string> with;
  std::size_t every = 1;
};

std::vector<Phone> phones(const std::vector<std::string>& symbols) {
  std::vector<Phone> result;
  for (const auto& written : symbols) {
    const auto phone = phone_from_symbol(written);
    if (!phone || !(is_consonant(*phone) || is_vowel(*phone))) {
      throw Error{fmt::format("--with: '{}' is no sound; write ARPAbet, e.g. TH,DH", written)};
    }
    result.push_back(*phone);
  }
  return result;
}

std::string scope_in_words(const ContactOptions& options) {
  std::string words =
      options.every == 1 ? "every syllable" : fmt::format("one in {} syllables", options.every);
  if (!options.with.empty()) words += fmt::format(" with {}", fmt::join(options.with, " or "));
  return words;
}

bool print_contacts(const synth::ContactTable& table) {
  std::vector<std::vector<std::string>> rows{{"sounds", "requirement", "met", "of", "worst"}};
  bool all_met = true;
  for (const auto& row : table.rows) {
    all_met = all_met && row.met == row.cases;
    rows.push_back({row.sounds,
                    row.requirement,
                    fmt::format("{}", row.met),
                    fmt::format("{}", row.cases),
                    row.cases == 0 ? "-" : fmt::format("{:.2f}  {}", row.worst, row.worst_case)});
  }
  print_text_table(rows, "llrrl");
  return all_met;
}

bool print_penetrations(const synth::ContactTable& table) {
  const auto& deepest = table.deepest;
  fmt::print(
      "\nHow deep parts lie in one another at the worst place of {} (mm; at most {}):\n"
      "  lip in lip {:.2f}, lips and cheeks in teeth {:.2f}, tongue in teeth {:.2f}, in the palate "
      "{:.2f}, in lips and cheeks {:.2f}\n",
      counted(table.pictures, "picture"),
      synth::kMostPenetration,
      deepest.lip_in_lip,
      deepest.flesh_in_teeth,
      deepest.tongue_in_teeth,
      deepest.tongue_in_palate,
      deepest.tongue_in_flesh);
  if (deepest.worst() <= synth::kMostPenetration) return true;
  fmt::print("  deepest in {}\n", table.deepest_case);
  return false;
}

ExitCode contacts(const ContactOptions& options) {
  const synth::SegmentTable table{inventory_file(options.file)};
  const synth::Head head{asset("synth/assets/head")};
  const bool is_told = isatty(STDERR_FILENO) == 1;
  const auto measured = synth::measure_contacts(
      head,
      table,
      {.rates = options.rates,
       .every = options.every,
       .with = phones(options.with),
       .threads = std::max(1U, std::thread::hardware_concurrency()),
       .progress = [is_told](double part_done) {
         if (is_told) fmt::print(stderr, "\r{:.0f} % of the syllables ", 100 * part_done);
       }});
  if (is_told) fmt::print(stderr, "\r{:40}\r", "");
  fmt::print("The drawn face in {} of all C V C at rates {}:\n\n",
             scope_in_words(options),
             fmt::join(options.rates, ", "));
  const bool all_met = print_contacts(measured);
  const bool none_deep = print_penetrations(measured);
  return all_met && none_deep ? ExitCode::Done : ExitCode::Findings;
}

}  // namespace

void add_segments_contacts(CLI::App& segments, Verb& chosen) {
  auto* const verb =
      segments.add_subcommand("contacts",
                              "Measures on the drawn face what decides lipreading, in every "
                              "syllable C V C, in pictures 60\n"
                              "times a second: whether lips shut, lip meets teeth, the tongue is "
                              "seen or at the ridge, lips\n"
                              "are round, and nothing lies in anything else. All of them take "
                              "half an hour of\n"
                              "processor time, shared among all cores; --every 50 some 20 "
                              "seconds on two.\n"
                              "Exit code: 0 done, 1 something is missed, 3 errors.\n\n"
                              "Examples:\n"
                              "  bimodal segments contacts --every 50\n"
                              "  bimodal segments contacts --with TH,DH --rates 2\n"
                              "  bimodal segments contacts mine.json --rates 1");
  auto options = std::make_shared<ContactOptions>();
  verb->add_option("FILE", options->file, "a file, or english (default), turkish-plateau");
  verb->add_option("--rates", options->rates, "speaking rates (0.5,1,2)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(finite_number())
      ->check(CLI::Range(0.1, 10.0));
  verb->add_option("--with", options->with, "only syllables with one of these sounds, e.g. TH,DH")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb->add_option("--every", options->every, "only each N-th syllable (1)")
      ->check(CLI::Range(1, 100'000));
  verb->callback([options, &chosen] { chosen = [options] { return contacts(*options); }; });
}

}  // namespace bimodal::runner

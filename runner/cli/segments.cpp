#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "runner/cli/protocol_file.hpp"
#include "runner/cli/segments_verbs.hpp"
#include "runner/cli/spoken_score.hpp"
#include "runner/cli/text_table.hpp"
#include "runner/cli/verbs.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/digest.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/timeline/inventory_file.hpp"
#include "synth/inspection/context_slopes.hpp"
#include "synth/speech/contact_check.hpp"

namespace bimodal::runner {

namespace {

constexpr std::array kRates{0.5, 0.7, 1.0, 1.4, 2.0};

struct CheckOptions {
  std::string file = "english";
  bool is_quick = false;
};

/// How many values have each source.
struct Share {
  std::size_t targets = 0;
  std::size_t dynamics = 0;
};

std::map<std::string, Share> shares_of(const synth::SegmentTable& table) {
  std::map<std::string, Share> shares;
  for (const Phone phone : all_phones().first(synth::kFaceSegmentCount)) {
    for (const auto& control : synth::controls().first<synth::kSpeechControlCount>()) {
      const auto& asked = table.at(phone, control.control);
      ++shares[asked.target_source].targets;
      ++shares[asked.dynamics_source].dynamics;
    }
  }
  return shares;
}

void print_shares(const synth::SegmentTable& table) {
  const auto shares = shares_of(table);
  std::vector<std::pair<std::string, Share>> rows(shares.begin(), shares.end());
  std::ranges::stable_sort(rows, std::ranges::greater{}, [](const auto& row) {
    return row.second.targets + row.second.dynamics;
  });
  constexpr auto kValues =
      static_cast<double>(synth::kFaceSegmentCount * synth::kSpeechControlCount);
  const auto percent = [](std::size_t count) {
    return count == 0 ? std::string{}
                      : fmt::format("{:.1f} %", 100.0 * static_cast<double>(count) / kValues);
  };
  std::vector<std::vector<std::string>> texts{{"source", "targets", "dynamics"}};
  for (const auto& [key, share] : rows) {
    texts.push_back({key, percent(share.targets), percent(share.dynamics)});
  }
  fmt::print("\nWhere the values come from ({} segments x {} controls):\n",
             synth::kFaceSegmentCount,
             synth::kSpeechControlCount);
  print_text_table(texts, "lrr");
  fmt::print("\n");
  for (const auto& [key, ignored] : rows) {
    fmt::print("  {}: {}\n", key, table.sources().at(key));
  }
}

/// Whether every contact is made.
bool print_contacts(const synth::SegmentTable& table) {
  fmt::print(
      "\nContacts of P B M (lips) and F V (lip and teeth) in every syllable CVC at rates {}:\n",
      fmt::join(kRates, ", "));
  std::fflush(stdout);
  const auto report = synth::check_contacts(table, kRates);
  if (report.missed.empty()) {
    fmt::print("  made in all of {}; the briefest lasts {:.0f} ms\n",
               counted(report.contexts, "context"),
               report.briefest.count());
    return true;
  }
  fmt::print("  MISSED (shorter than one picture at 60 Hz, {:.1f} ms) in {} of {}:\n",
             synth::kShownPicture.count(),
             report.missed.size(),
             counted(report.contexts, "context"));
  constexpr std::size_t kShown = 12;
  for (std::size_t i = 0; i < std::min(kShown, report.missed.size()); ++i) {
    const auto& missed = report.missed[i];
    fmt::print("    {} in {} at rate {}: {:.0f} ms\n",
               symbol(missed.phone),
               missed.context,
               missed.rate,
               missed.longest.count());
  }
  if (report.missed.size() > kShown) fmt::print("    ...\n");
  fmt::print(
      "  move the target of lip_closure or lower_lip_tuck further beyond 1, or raise its "
      "alpha\n");
  return false;
}

ExitCode check(const CheckOptions& options) {
  const auto file = inventory_file(options.file);
  std::vector<Diagnostic> diagnostics;
  const auto table = synth::SegmentTable::parse(read_file(file), file.string(), diagnostics);
  print(diagnostics);
  if (!table) return ExitCode::InvalidInput;
  fmt::print("{}: every segment sets every control\n", file.string());
  print_shares(*table);
  if (options.is_quick) return ExitCode::Done;
  return print_contacts(*table) ? ExitCode::Done : ExitCode::Findings;
}

ExitCode slopes(const std::string& segments) {
  const synth::SegmentTable table{inventory_file(segments)};
  const synth::Head head{asset("synth/assets/head")};
  std::vector<std::vector<std::string>> rows{
      {"consonants", "articulator", "face", "measured", "difference"}};
  std::vector<std::string> words;
  for (const auto& slope : synth::context_slopes(table, head)) {
    const double difference = slope.slope - slope.measured;
    const bool is_notable = std::abs(difference) > synth::kNotableDifference;
    rows.push_back({std::string{slope.consonants},
                    std::string{slope.articulator},
                    fmt::format("{:.2f}", slope.slope),
                    fmt::format("{:.2f}", slope.measured),
                    fmt::format("{:+.2f}{}", difference, is_notable ? " *" : "  ")});
    if (is_notable) {
      words.push_back(
          fmt::format("{}, {}: {}",
                      slope.consonants,
                      slope.articulator,
                      slope.word.empty() ? "of this inventory; no word on it" : slope.word));
    }
  }
  fmt::print(
      "Where a consonant's articulators go with the vowels /a i u/ around it: 0 the consonant "
      "decides alone, 1 the vowels do.\nMeasured: one German talker by magnetic resonance "
      "(VocalTractLab's speaker JD3).\n\n");
  print_text_table(rows, "llrrr");
  if (!words.empty()) fmt::print("\n* more than {} apart:\n", synth::kNotableDifference);
  for (const auto& word : words) fmt::print("  {}\n", word);
  return ExitCode::Done;
}

}  // namespace

void add_segments(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "segments",
      "The inventory of segments: what each asks of each control of the face, how strongly, for\n"
      "how long, and where the values come from.\n\n"
      "Examples:\n"
      "  bimodal segments check                          the English inventory: sources, contacts\n"
      "  bimodal segments check mine.json                one of your own\n"
      "  bimodal segments show B -o b.svg                every value of B, and its dominance\n"
      "  bimodal segments slopes                         coarticulation beside measured talkers\n"
      "  bimodal segments contacts --every 50            lips, teeth and tongue of the drawn face");
  verb->require_subcommand(1);

  auto* const checking = verb->add_subcommand(
      "check",
      "Finds every mistake in an inventory, tells the share of each source, and whether lips and\n"
      "teeth meet in every syllable.\n"
      "Exit code: 0 done, 1 contacts are missed, 3 errors.");
  auto check_options = std::make_shared<CheckOptions>();
  checking->add_option(
      "FILE", check_options->file, "a file, or english (default), turkish-plateau");
  checking->add_flag(
      "--quick", check_options->is_quick, "without the contacts, which take seconds");
  checking->callback(
      [check_options, &chosen] { chosen = [check_options] { return check(*check_options); }; });

  auto* const sloping = verb->add_subcommand(
      "slopes",
      "How far consonants give way to the vowels around them, beside measured values, with a word\n"
      "on every notable difference.");
  auto segments = std::make_shared<std::string>("english");
  sloping->add_option("FILE", *segments, "a file, or english (default), turkish-plateau");
  sloping->callback([segments, &chosen] { chosen = [segments] { return slopes(*segments); }; });

  add_segments_show(*verb, chosen);
  add_segments_contacts(*verb, chosen);
}

}  // namespace bimodal::runner

#include <algorithm>
#include <chrono>
#include <set>

#include <fmt/format.h>

#include "runner/cli/protocol_file.hpp"
#include "runner/cli/sound_check.hpp"
#include "runner/cli/verbs.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

using protocols::Assignment;
using protocols::ReadProtocol;

/// From the stimulus's end to Enter, on average; a guess, used only for the estimate of duration.
constexpr double kAnswerSeconds = 4.0;
constexpr double kWordSeconds = 1.0;

double seconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

int sessions_of(const protocols::Protocol& protocol) {
  return protocol.assignment == Assignment::Once ? 1 : static_cast<int>(protocol.conditions.size());
}

void print_summary(const ReadProtocol& read, std::size_t trials) {
  const auto& protocol = read.protocol;
  const auto& times = protocol.intervals;
  const double trial_s = seconds(times.fixation + times.lead + times.trail + times.pause) +
                         kWordSeconds + kAnswerSeconds;
  fmt::print("{}\n", protocol.title);
  fmt::print("  words        {} of list \"{}\", {} for practice\n",
             read.words.words.size(),
             read.words.name,
             read.practice.size());
  for (const auto& condition : protocol.conditions) {
    fmt::print("  condition    {:<14} hears {:<14} sees {:<6} {}\n",
               condition.name,
               condition.auditory_talker.value_or("nothing"),
               condition.visual_talker.value_or("no face"),
               condition.snr ? fmt::format("{:g} dB S/N in {:g}-{:g} Hz",
                                           condition.snr->count(),
                                           protocol.sound.noise.band_low.count(),
                                           protocol.sound.noise.band_high.count())
                             : std::string{});
  }
  fmt::print("  assignment   {}\n",
             protocol.assignment == Assignment::Once
                 ? "once: each word in one condition per participant"
                 : fmt::format("every-condition: over {} sessions", sessions_of(protocol)));
  fmt::print("  a session    {} trials, about {:.0f} minutes\n",
             trials,
             static_cast<double>(trials) * trial_s / 60.0);
}

/// Sounds of as many participants as there are lists, so that every word is heard in every
/// condition.
std::vector<Diagnostic> check_all_sounds(const ReadProtocol& read, const std::string& file) {
  SpeechBank bank{read.protocol.sound.rate};
  TrialPreparer preparer{read.protocol, bank, nullptr, Hertz{60}};
  std::vector<Diagnostic> diagnostics;
  const int lists = static_cast<int>(read.protocol.conditions.size());
  for (int participant = 1; participant <= lists; ++participant) {
    const auto plan = protocols::make_plan(
        read.protocol, read.words, read.practice, {.participant_number = participant});
    auto found = check_sounds(read.protocol, plan, preparer, file);
    for (auto& diagnostic : found) {
      if (std::ranges::find(diagnostics, diagnostic.pointer, &Diagnostic::pointer) ==
          diagnostics.end()) {
        diagnostics.push_back(std::move(diagnostic));
      }
    }
  }
  return diagnostics;
}

ExitCode check(const std::string& named) {
  const auto read = load_protocol(named);
  if (!read) return ExitCode::InvalidInput;
  const auto found = check_all_sounds(*read, find_protocol(named).string());
  print(found);
  const auto plan = protocols::make_plan(read->protocol, read->words, read->practice, {});
  print_summary(*read, plan.size());
  if (has_errors(found)) return ExitCode::InvalidInput;
  const auto warnings = read->diagnostics.size() + found.size();
  if (warnings == 0) {
    fmt::print("no mistakes found\n");
  } else {
    fmt::print("usable, with {} warning(s)\n", warnings);
  }
  return warnings == 0 ? ExitCode::Done : ExitCode::Findings;
}

}  // namespace

void add_check(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "check",
      "Reads a protocol whole, with every file that it needs, and prints all mistakes at once.\n"
      "Makes every sound, so that none is found to clip later.\n"
      "Exit code: 0 clean, 1 warnings, 3 errors.\n\n"
      "Examples:\n  bimodal check words414\n  bimodal check my-experiment.json");
  auto named = std::make_shared<std::string>();
  verb->add_option("PROTOCOL", *named, "a JSON file, or the name of a protocol of the library")
      ->required();
  verb->callback([named, &chosen] { chosen = [named] { return check(*named); }; });
}

}  // namespace bimodal::runner

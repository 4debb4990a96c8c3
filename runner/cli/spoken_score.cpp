#include "runner/cli/spoken_score.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "runner/cli/option_checks.hpp"
#include "runner/cli/said_text.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/lower_case.hpp"
#include "stimuli/timeline/inventory_file.hpp"
#include "stimuli/words/plain_text.hpp"
#include "synth/speech/durations.hpp"
#include "synth/voice/voice.hpp"

namespace bimodal::runner {

namespace {

std::vector<TimedSegment> timed_phones(const std::vector<Phone>& phones) {
  return synth::timed(std::vector<Segment>(phones.begin(), phones.end()));
}

std::vector<TimedSegment> timed_by_festival(const SpokenOptions& options) {
  const auto item = synth::Voice{options.voice.value_or("kal")}.speak(ascii_text(options.text));
  std::vector<TimedSegment> segments;
  for (const auto& phone : item.utterance.phones) {
    segments.push_back({.segment = phone.phone, .start = phone.start, .duration = phone.duration});
  }
  return segments;
}

std::vector<TimedSegment> timed_segments(const SpokenOptions& options) {
  const auto from = options.from.value_or("text");
  const auto method = options.method.value_or("dictionary");
  if (from == "arpabet") return synth::typed_segments(options.text);
  if (from != "text") return timed_phones(read_phones(options.text, notation_named(from)));
  if (method == "festival") return timed_by_festival(options);
  return timed_phones(joined(said_words(options.text, method)));
}

}  // namespace

void add_spoken_options(CLI::App& verb, SpokenOptions& options) {
  verb.add_option("SCORE|TEXT",
                  options.text,
                  "a text; a transcription with --from; or a score: a file that ends with .json")
      ->required();
  verb.add_option(
          "--method",
          options.method,
          "how a text is read: dictionary (default), nrl (letter-to-sound rules), or festival, "
          "which also times it; the others have intrinsic durations")
      ->check(CLI::IsMember({"dictionary", "nrl", "festival"}));
  verb.add_option("--from",
                  options.from,
                  "what TEXT is: text (default), arpabet (\"S:140 T:60 UW1:200\", durations in ms "
                  "and stress where wanted), ipa, xsampa")
      ->check(CLI::IsMember({"text", "arpabet", "ipa", "xsampa"}));
  verb.add_option("--voice", options.voice, "Festival's voice: kal (default), slt")
      ->check(CLI::IsMember({"kal", "slt"}));
  verb.add_option(
          "--rate", options.rate, "speaking rate: 2 halves all durations, 0.5 doubles them (1)")
      ->check(finite_number())
      ->check(CLI::Range(synth::kSlowestRate, synth::kFastestRate));
  verb.add_option(
      "--segments", options.segments, "inventory: a file, or english (default), turkish-plateau");
}

void add_account_option(CLI::App& verb, std::string& account) {
  std::vector<std::string> names;
  for (const auto& row : accounts()) names.emplace_back(row.name);
  verb.add_option("--account",
                  account,
                  fmt::format("account of coarticulation: {}; the first is the default",
                              fmt::join(names, ", ")))
      ->check(CLI::IsMember(names));
}

synth::SegmentTable chosen_segments(const SpokenOptions& options) {
  return synth::SegmentTable{inventory_file(options.segments)};
}

namespace {

/// Warnings go to standard error: what is asked for may be on standard output.
synth::Score score_of_file(const std::string& file) {
  std::vector<Diagnostic> warnings;
  auto score = synth::read_score(file, warnings);
  for (const auto& warning : warnings) fmt::print(stderr, "{}\n", describe(warning));
  return score;
}

/// Options that would have no effect are mistakes.
void refuse_idle_options(const SpokenOptions& options, bool is_score) {
  const auto refuse = [](std::string_view option, std::string_view reason) {
    throw Error{fmt::format("{} has no effect: {}; leave it out", option, reason)};
  };
  if (is_score && options.from) refuse("--from", "a score is read as it is");
  const bool is_text = !is_score && options.from.value_or("text") == "text";
  if (!is_text && options.method) refuse("--method", "only texts are read by a method");
  if (options.voice && options.method != "festival") {
    refuse("--voice", "only --method festival has a voice");
  }
}

/// A name that ends with ".json"; another file that is there is refused, not said as a text.
bool names_score(const std::string& text) {
  if (lower_case(std::filesystem::path{text}.extension().string()) == ".json") return true;
  std::error_code ignored;
  if (text.find('/') != std::string::npos && std::filesystem::exists(text, ignored)) {
    throw Error{fmt::format(
        "'{}' is a file or folder, but no score; the name of a score ends with .json", text)};
  }
  return false;
}

}  // namespace

synth::Score spoken_score(const SpokenOptions& options) {
  const bool is_score = names_score(options.text);
  refuse_idle_options(options, is_score);
  return synth::at_rate(
      is_score ? score_of_file(options.text) : synth::score_of(timed_segments(options)),
      options.rate);
}

}  // namespace bimodal::runner

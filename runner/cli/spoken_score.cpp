#include "runner/cli/spoken_score.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "runner/cli/option_checks.hpp"
#include "runner/cli/said_text.hpp"
#include "stimuli/audio/time_scale.hpp"
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

/// Without `phones`, Festival reads the text.
synth::SpokenItem said_by_festival(const SpokenOptions& options,
                                   const std::vector<Phone>& phones = {}) {
  const synth::Voice voice{options.voice.value_or("kal")};
  return voice.speak(phones.empty() ? ascii_text(options.text) : options.text, phones);
}

std::vector<TimedSegment> segments_of(const Utterance& utterance) {
  std::vector<TimedSegment> segments;
  for (const auto& phone : utterance.phones) {
    segments.push_back({.segment = phone.phone, .start = phone.start, .duration = phone.duration});
  }
  return segments;
}

std::vector<TimedSegment> timed_segments(const SpokenOptions& options) {
  const auto from = options.from.value_or("text");
  const auto method = options.method.value_or("dictionary");
  if (from == "arpabet") return synth::typed_segments(options.text);
  if (from != "text") return timed_phones(read_phones(options.text, notation_named(from)));
  if (method == "festival") return segments_of(said_by_festival(options).utterance);
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

/// Whether a text is the name of something that is there: with a folder, or an ending (mine.wav).
bool names_what_is_there(const std::string& text) {
  std::error_code ignored;
  const bool is_name =
      text.find('/') != std::string::npos || std::filesystem::path{text}.has_extension();
  return is_name && std::filesystem::exists(text, ignored);
}

/// A name that ends with ".json"; another file that is there is refused, not said as a text.
bool names_score(const std::string& text) {
  if (lower_case(std::filesystem::path{text}.extension().string()) == ".json") return true;
  if (!names_what_is_there(text)) return false;
  throw Error{
      fmt::format("'{}' is a file or folder, but no score; the name of a score ends with .json (a "
                  "sound is given to `render` by --audio, and `bimodal align` finds its phones)",
                  text)};
}

}  // namespace

synth::Score spoken_score(const SpokenOptions& options) {
  const bool is_score = names_score(options.text);
  refuse_idle_options(options, is_score);
  return synth::at_rate(
      is_score ? score_of_file(options.text) : synth::score_of(timed_segments(options)),
      options.rate);
}

namespace {

/// What a voice is to say of a transcription with typed durations and ambiguous sounds.
std::vector<Phone> phones_to_say(const std::string& text) {
  const auto segments = synth::typed_segments(text);
  std::vector<Segment> plain;
  for (const auto& timed : segments) {
    if (timed.segment.is_ambiguous()) {
      throw Error{fmt::format("no voice can say the ambiguous sound {}; leave the voice out",
                              symbol(timed.segment))};
    }
    plain.push_back(timed.segment);
  }
  const auto own = synth::timed(plain);
  if (!std::ranges::equal(segments, own, {}, &TimedSegment::duration, &TimedSegment::duration)) {
    throw Error{fmt::format(
        "the voice times \"{}\" itself; leave durations and stress out, or the voice", text)};
  }
  std::vector<Phone> phones;
  for (const auto& segment : plain) phones.push_back(segment.from);
  return phones;
}

/// Without the rest around, which a voice adds.
std::vector<Phone> without_margins(std::vector<Phone> phones) {
  const auto is_sound = [](Phone phone) { return phone != Phone::Rest; };
  phones.erase(phones.begin(), std::ranges::find_if(phones, is_sound));
  while (!phones.empty() && !is_sound(phones.back())) phones.pop_back();
  return phones;
}

}  // namespace

VoicedScore voiced_score(const SpokenOptions& options) {
  if (names_score(options.text)) {
    throw Error{fmt::format(
        "no voice says the score '{}'; give a sound of your own, or leave the voice out",
        options.text)};
  }
  if (options.method.value_or("festival") != "festival") {
    throw Error{fmt::format(
        "what is read by --method {} has no voice; leave the method out, and Festival reads and "
        "times the text, or leave the voice out",
        *options.method)};
  }
  const auto from = options.from.value_or("text");
  if (from != "text" && options.method) refuse_idle_options(options, false);
  std::vector<Phone> phones;
  if (from == "arpabet") phones = without_margins(phones_to_say(options.text));
  if (from == "ipa" || from == "xsampa") {
    phones = without_margins(read_phones(options.text, notation_named(from)));
  }
  const auto item = said_by_festival(options, phones);
  return {.score = synth::at_rate(synth::score_of(segments_of(item.utterance)), options.rate),
          .sound = change_rate(item.sound, options.rate)};
}

}  // namespace bimodal::runner

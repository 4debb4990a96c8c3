#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "runner/cli/said_text.hpp"
#include "runner/cli/verbs.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/timeline/phone_notation.hpp"
#include "stimuli/words/dictionary.hpp"
#include "stimuli/words/letter_to_sound.hpp"
#include "stimuli/words/plain_text.hpp"
#include "stimuli/words/text_phones.hpp"
#include "synth/voice/voice.hpp"

namespace bimodal::runner {

namespace {

struct PhonesOptions {
  std::vector<std::string> text;
  std::string method = "dictionary";
  std::string show = "arpabet";
  std::string from = "text";
  bool variants = false;
};

/// What Festival says, without the rest at both ends.
std::vector<Phone> spoken_by_festival(const std::string& text) {
  const auto item = synth::Voice{"kal"}.speak(ascii_text(text));
  std::vector<Phone> phones;
  for (const auto& timed : item.utterance.phones) phones.push_back(timed.phone);
  if (!phones.empty() && phones.front() == Phone::Rest) phones.erase(phones.begin());
  if (!phones.empty() && phones.back() == Phone::Rest) phones.pop_back();
  return phones;
}

std::vector<Phone> phones_of(const std::string& text, const PhonesOptions& options) {
  if (options.from == "arpabet" && text.find_first_of(":~") != std::string::npos) {
    throw Error{fmt::format(
        "\"{}\": durations (\"S:140\") and ambiguous sounds (\"B~W:3/8\") are articulated, not "
        "spelled; give it to `bimodal tracks --from arpabet`, or leave them out",
        text)};
  }
  if (options.from != "text") return read_phones(text, notation_named(options.from));
  if (options.method == "festival") return spoken_by_festival(text);
  return joined(said_words(text, options.method));
}

/// "read R EH D" and "read(2) R IY D": every way in which the dictionary says each word, in the
/// dictionary's own format; what it lacks as the rules have it.
void print_variants(const std::string& text, Notation notation) {
  const Dictionary dictionary{Dictionary::installed()};
  const auto words = phones_by_dictionary(text, dictionary, LetterToSound::shipped());
  tell_doubts(words);
  for (const auto& word : words) {
    std::size_t place = 0;
    for (const auto& phones : dictionary.pronunciations(word.written)) {
      const auto choice = ++place > 1 ? fmt::format("({})", place) : "";
      fmt::print("{}{} {}\n", word.written, choice, write_phones(phones, notation));
    }
    if (place == 0) fmt::print("{} {}\n", word.written, write_phones(word.phones, notation));
  }
}

/// Refuses options that have no meaning together.
void judge(const PhonesOptions& options) {
  const bool by_dictionary = options.method == "dictionary";
  if (options.from != "text" && (options.variants || !by_dictionary)) {
    throw Error{"a transcription is not looked up; leave --method and --variants out, or --from"};
  }
  if (options.variants && !by_dictionary) {
    throw Error{"--variants are the pronunciations of the dictionary; leave --method out"};
  }
}

ExitCode tell(const PhonesOptions& options) {
  judge(options);
  const auto text = fmt::format("{}", fmt::join(options.text, " "));
  const auto notation = notation_named(options.show);
  if (options.variants) {
    print_variants(text, notation);
    return ExitCode::Done;
  }
  for (const Phone phone : phones_of(text, options)) {
    fmt::print("{}\n", phone == Phone::Rest ? symbol(phone) : written(phone, notation));
  }
  return ExitCode::Done;
}

}  // namespace

void add_phones(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "phones",
      "Tells how a text is said: one phone a line, \"rest\" where words have a pause between\n"
      "them. The dictionary is the CMU Pronouncing Dictionary; words that it lacks are read by\n"
      "letter-to-sound rules (Elovitz et al. 1976), which is told on standard error. The\n"
      "dictionary says numbers as a whole (\"22\" twenty two), the rules digit by digit.\n"
      "Festival reads the text as its voice kal does: it pauses between clauses, not at every "
      "comma.\n"
      "Exit code: 0 done, 3 errors.\n\n"
      "Examples:\n"
      "  bimodal phones \"Temporary food, stew.\"\n"
      "  bimodal phones --method nrl blick               by the letter-to-sound rules alone\n"
      "  bimodal phones --variants read                  all pronunciations, one a line\n"
      "  bimodal phones \"I read(2) it\"                   with the second one of \"read\"\n"
      "  bimodal phones --show ipa stew                  s t u\n"
      "  bimodal phones --from xsampa \"stju:\"            S T Y UW");
  auto options = std::make_shared<PhonesOptions>();
  verb->add_option("TEXT", options->text, "what is said; a transcription with --from")->required();
  verb->add_option(
          "--method",
          options->method,
          "how words are read: dictionary (default), nrl (letter-to-sound rules), festival")
      ->check(CLI::IsMember({"dictionary", "nrl", "festival"}));
  verb->add_option(
          "--show", options->show, "how phones are written: arpabet (default), ipa, xsampa")
      ->check(CLI::IsMember({"arpabet", "ipa", "xsampa"}));
  verb->add_option("--from", options->from, "what TEXT is: text (default), arpabet, ipa, xsampa")
      ->check(CLI::IsMember({"text", "arpabet", "ipa", "xsampa"}));
  verb->add_flag("--variants",
                 options->variants,
                 "every pronunciation that the dictionary has of each word, one a line");
  verb->callback([options, &chosen] { chosen = [options] { return tell(*options); }; });
}

}  // namespace bimodal::runner

#include <algorithm>
#include <cctype>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "runner/cli/option_checks.hpp"
#include "runner/cli/verbs.hpp"
#include "stimuli/alignment/aligner.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/base/milliseconds.hpp"
#include "stimuli/labels/label_file.hpp"
#include "stimuli/video/sound_track.hpp"
#include "stimuli/words/dictionary.hpp"

namespace bimodal::runner {

namespace {

struct AlignOptions {
  std::string sound;
  std::string text;
  std::string phones;
  std::string dictionary;  ///< empty: the installed one
  std::string output;      ///< empty: only tell
};

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream{text};
  for (std::string part; stream >> part;) parts.push_back(part);
  return parts;
}

/// As the dictionary spells it: lower case, without the punctuation around it.
std::string spelling_of(std::string_view typed) {
  constexpr std::string_view kAround = ".,;:!?\"()";
  const auto first = typed.find_first_not_of(kAround);
  if (first == std::string_view::npos) return {};
  std::string spelling{typed.substr(first, typed.find_last_not_of(kAround) - first + 1)};
  std::ranges::transform(spelling, spelling.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  return spelling;
}

std::vector<SpokenWord> words_of(const AlignOptions& options) {
  const Dictionary dictionary{options.dictionary.empty()
                                  ? Dictionary::installed()
                                  : std::filesystem::path{options.dictionary}};
  std::vector<SpokenWord> words;
  std::vector<std::string> unknown;
  for (const auto& typed : parts_of(options.text)) {
    const auto spelling = spelling_of(typed);
    if (spelling.empty()) continue;
    const auto known = dictionary.pronunciations(spelling);
    if (known.empty()) unknown.push_back(fmt::format("\"{}\"", spelling));
    words.push_back({spelling, {known.begin(), known.end()}});
  }
  if (!unknown.empty()) {
    throw Error{
        fmt::format("looking up what is said in '{}': the dictionary does not have {}; give "
                    "the phones instead, e.g. --phones \"S T UW\", or a --dictionary FILE "
                    "with lines such as \"stew S T UW\"",
                    options.sound,
                    fmt::join(unknown, ", "))};
  }
  return words;
}

SpokenWord word_of_phones(const AlignOptions& options) {
  Pronunciation phones;
  for (const auto& symbol : parts_of(options.phones)) {
    const auto phone = phone_from_symbol(symbol);
    if (!phone) {
      throw Error{
          fmt::format("'{}' is no phone; write ARPAbet symbols, e.g. --phones \"S T UW\"", symbol)};
    }
    phones.push_back(*phone);
  }
  return {.spelling = {}, .pronunciations = {phones}};
}

/// The times of the words that have a spelling.
std::vector<Label> word_labels(const Alignment& found) {
  std::vector<Label> labels;
  for (const auto& word : found.words) {
    if (word.spelling.empty()) continue;
    const auto& phones = found.utterance.phones;
    labels.push_back({.start = phones.at(word.first_phone).start,
                      .end = phones.at(word.first_phone + word.phones - 1).end(),
                      .text = word.spelling});
  }
  return labels;
}

void print_phones(const Alignment& found) {
  fmt::print("  start ms    end ms  duration  phone\n");
  std::size_t word = 0;
  for (std::size_t i = 0; i < found.utterance.phones.size(); ++i) {
    const auto& timed = found.utterance.phones[i];
    const bool begins = word < found.words.size() && found.words[word].first_phone == i;
    fmt::print("{:>10.1f}{:>10.1f}{:>10.1f}  {:<5}{}\n",
               milliseconds(timed.start),
               milliseconds(timed.end()),
               milliseconds(timed.duration),
               symbol(timed.phone),
               begins ? found.words[word].spelling : std::string{});
    if (begins) ++word;
  }
}

/// How many words are doubtful, after a warning for each.
std::size_t warn_of_doubtful_words(const Alignment& found, const AlignOptions& options) {
  std::size_t doubtful = 0;
  for (std::size_t i = 0; i < found.words.size(); ++i) {
    if (found.fit_of_word[i] >= kDoubtfulFit) continue;
    ++doubtful;
    const auto& word = found.words[i];
    fmt::print(stderr,
               "{}: warning: {} at {:.0f} ms fits the sound badly ({:.2f}, below {:g}); listen "
               "whether it is what is said\n",
               options.sound,
               word.spelling.empty() ? "the word" : fmt::format("\"{}\"", word.spelling),
               milliseconds(found.utterance.phones[word.first_phone].start),
               found.fit_of_word[i],
               kDoubtfulFit);
  }
  return doubtful;
}

ExitCode align(const AlignOptions& options) {
  const auto sound = read_sound_track(options.sound);
  const auto words =
      options.text.empty() ? std::vector{word_of_phones(options)} : words_of(options);
  const auto found = Aligner{}.align(sound, words);
  if (options.output.empty()) {
    print_phones(found);
  } else {
    const bool phones_only = holds_one_tier(options.output);
    write_labels(
        options.output,
        labels_of(found.utterance, phones_only ? std::vector<Label>{} : word_labels(found)));
  }
  std::size_t phones = 0;
  for (const auto& word : found.words) phones += word.phones;
  fmt::print("{}: {}, {}, fit {:.2f}\n",
             options.output.empty() ? options.sound : options.output,
             counted(found.words.size(), "word"),
             counted(phones, "phone"),
             found.fit);
  return warn_of_doubtful_words(found, options) == 0 ? ExitCode::Done : ExitCode::Findings;
}

}  // namespace

void add_align(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "align",
      "Finds when each phone sounds in a recording of known words.\n"
      "Give a clean recording, with or without silence around the words; mix noise afterwards.\n"
      "The fit is 0 at best; a word whose fit is low is warned of. Exit code: 0 done, 1 warnings, "
      "3 "
      "errors.\n\n"
      "Examples:\n"
      "  bimodal align stew.wav --text stew\n"
      "  bimodal align bbaf2n.mpg --text \"bin blue at f two now\" -o bbaf2n.TextGrid\n"
      "  bimodal align blick.flac --phones \"B L IH K\" -o blick.lab");
  auto options = std::make_shared<AlignOptions>();
  verb->add_option(
          "SOUND", options->sound, "a sound file, or a video with sound; up to ten minutes")
      ->required();
  auto* const what = verb->add_option_group("what is said");
  what->add_option("--text", options->text, "the words, to be looked up in the dictionary");
  what->add_option("--phones", options->phones, "the phones of one word, in ARPAbet");
  what->require_option(1);
  verb->add_option("--dictionary", options->dictionary, "in CMU format, instead of the installed");
  verb->add_option("-o,--output",
                   options->output,
                   "label file to be written: .TextGrid, .lab, .align or .csv (phones are printed)")
      ->check(in_a_folder_that_exists());
  verb->callback([options, &chosen] { chosen = [options] { return align(*options); }; });
}

}  // namespace bimodal::runner

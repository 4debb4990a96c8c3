#include <cstdio>
#include <memory>

#include <fmt/format.h>
#include <unistd.h>

#include "runner/cli/corpus_verbs.hpp"
#include "runner/cli/protocol_file.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/corpus/spoken_text.hpp"

namespace bimodal::runner {

Corpus open_corpus(const std::string& place) {
  std::vector<Diagnostic> diagnostics;
  auto corpus = read_corpus(place, diagnostics);
  print(diagnostics);
  if (has_errors(diagnostics)) {
    throw Error{fmt::format("the corpus '{}' cannot be used as it is", place)};
  }
  return corpus;
}

namespace {

std::filesystem::path word_list_file(const std::string& named) {
  const std::filesystem::path path{named};
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored) || path.has_extension() || path.has_parent_path()) {
    return path;
  }
  try {
    return asset("stimuli/assets/words/" + named + ".json");
  } catch (const Error&) {
    throw Error{
        fmt::format("there is no word list '{}'; give a file (.json, or .txt with words), or the "
                    "name of a list of the project, such as monosyllables-414",
                    named)};
  }
}

/// The words of a text, each once, as the dictionary says them.
WordList words_of_plain_text(const std::filesystem::path& file) {
  WordList list{.name = file.stem().string()};
  Pronouncer pronouncer{{}};
  std::vector<std::string> unknown;
  std::error_code ignored;
  if (std::filesystem::is_empty(file, ignored)) {
    throw Error{fmt::format("the word list '{}' is empty; write the words that are to be taken",
                            file.string())};
  }
  for (const auto& word : read_text(file)) {
    if (std::ranges::find(list.words, word, &Word::spelling) != list.words.end()) continue;
    const auto spoken = pronouncer.find(word);
    if (!spoken) unknown.push_back(word);
    list.words.push_back({word, spoken ? spoken->pronunciations.front() : Pronunciation{}});
  }
  if (unknown.empty()) return list;
  throw Error{
      fmt::format("cannot use the words of '{}': the pronouncing dictionary does not have \"{}\"; "
                  "correct the spelling, or write a word list with phones (.json)",
                  file.string(),
                  fmt::join(unknown, "\", \""))};
}

}  // namespace

WordList words_named(const std::string& named) {
  const auto file = word_list_file(named);
  if (file.extension() == ".txt") return words_of_plain_text(file);
  std::vector<Diagnostic> diagnostics;
  auto list = read_word_list(file, diagnostics);
  print(diagnostics);
  if (has_errors(diagnostics)) {
    throw Error{fmt::format("the word list '{}' cannot be used as it is", file.string())};
  }
  return list;
}

Progress progress_on_terminal() {
  if (isatty(STDERR_FILENO) == 0) return {};
  auto last = std::make_shared<std::pair<std::string, int>>("", -1);
  return [last](std::string_view deed, double part) {
    const int tenths = static_cast<int>(part * 10.0);
    if (last->first == deed && last->second == tenths) return;
    *last = {std::string{deed}, tenths};
    fmt::print(stderr, "\r{} {:3d} %{}", deed, tenths * 10, part >= 1.0 ? "\n" : "");
    std::fflush(stderr);
  };
}

void add_corpus(CLI::App& app, Verb& chosen) {
  auto* const corpus = app.add_subcommand(
      "corpus",
      "Makes and judges corpora: a talker's recordings, cut into words, with every phone's "
      "time.\n\n"
      "Examples:\n"
      "  bimodal corpus record --words monosyllables-414 -o anna-takes\n"
      "  bimodal corpus build reading.mp4 --words monosyllables-414 --talker anna -o anna\n"
      "  bimodal corpus check anna       is everything there, and good?\n"
      "  bimodal corpus sheet anna       every word as pictures and sound wave, to look at\n"
      "  bimodal corpus list anna        what is in it\n"
      "  bimodal corpus accept anna stew-2");
  corpus->require_subcommand(1);
  add_corpus_record(*corpus, chosen);
  add_corpus_build(*corpus, chosen);
  add_corpus_check(*corpus, chosen);
  add_corpus_list(*corpus, chosen);
  add_corpus_sheet(*corpus, chosen);
  add_corpus_accept(*corpus, chosen);
}

}  // namespace bimodal::runner

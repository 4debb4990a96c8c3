#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "runner/cli/corpus_verbs.hpp"
#include "runner/cli/text_table.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/csv.hpp"
#include "stimuli/base/draft.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/corpus/word_list_of.hpp"

namespace bimodal::runner {

namespace {

struct ListOptions {
  std::string corpus;
  bool words = false;
  bool csv = false;
  std::string as_list;
};

double seconds(Duration duration) {
  return std::chrono::duration<double>{duration}.count();
}

void print_csv(const Corpus& corpus) {
  fmt::print("item,word,phones,recording,talker,start_s,end_s,doubt\n");
  for (const auto& item : corpus.items) {
    const auto& recording = corpus.recordings[item.recording];
    fmt::print("{},{},{},{},{},{:.6f},{:.6f},{}\n",
               csv_field(item.name),
               csv_field(item.word),
               spell(pronunciation_of(item)),
               csv_field(recording.file),
               csv_field(recording.talker),
               seconds(item.start),
               seconds(item.end),
               csv_field(item.doubt));
  }
}

void print_words(const Corpus& corpus) {
  for (const auto& word : word_list_of(corpus).words) fmt::print("{}\n", word.spelling);
}

void print_table(const Corpus& corpus) {
  std::vector<std::vector<std::string>> rows{
      {"item", "word", "phones", "talker", "start s", "ms", "recording", "doubt"}};
  for (const auto& item : corpus.items) {
    const auto& recording = corpus.recordings[item.recording];
    rows.push_back({item.name,
                    item.word,
                    spell(pronunciation_of(item)),
                    recording.talker,
                    fmt::format("{:.2f}", seconds(item.start)),
                    fmt::format("{:.0f}", 1000.0 * seconds(item.end - item.start)),
                    recording.file,
                    item.doubt});
  }
  print_text_table(rows, "llllrrll");
}

void write_list(const Corpus& corpus, const std::string& file) {
  const auto list = word_list_of(corpus);
  std::vector<std::string> lines;
  for (const auto& word : list.words) {
    lines.push_back(fmt::format("    {{\"word\": {}, \"phones\": [\"{}\"]}}",
                                nlohmann::json(word.spelling).dump(),
                                fmt::join(symbols_of(word.phones), "\", \"")));
  }
  write_file(file,
             fmt::format("{{\n  \"name\": {},\n  \"words\": [\n{}\n  ]\n}}\n",
                         nlohmann::json(list.name).dump(),
                         fmt::join(lines, ",\n")));
  fmt::print("{}: {}\n", file, counted(list.words.size(), "word"));
}

ExitCode list(const ListOptions& options) {
  const auto corpus = open_corpus(options.corpus);
  if (!options.as_list.empty()) {
    write_list(corpus, options.as_list);
  } else if (options.words) {
    print_words(corpus);
  } else if (options.csv) {
    print_csv(corpus);
  } else {
    print_table(corpus);
  }
  return ExitCode::Done;
}

}  // namespace

void add_corpus_list(CLI::App& corpus, Verb& chosen) {
  auto* const verb = corpus.add_subcommand(
      "list",
      "What is in a corpus.\n\n"
      "Examples:\n"
      "  bimodal corpus list anna\n"
      "  bimodal corpus list anna --csv > anna.csv\n"
      "  bimodal corpus list anna --as-list anna-words.json     a word list for a protocol");
  auto options = std::make_shared<ListOptions>();
  verb->add_option("CORPUS", options->corpus, "a folder with corpus.json")->required();
  verb->add_flag("--words", options->words, "only the words that can be used without doubt");
  verb->add_flag("--csv", options->csv, "a table for programs (RFC 4180)");
  verb->add_option("--as-list",
                   options->as_list,
                   "write the words that can be used without doubt as a word list for protocols");
  verb->callback([options, &chosen] { chosen = [options] { return list(*options); }; });
}

}  // namespace bimodal::runner

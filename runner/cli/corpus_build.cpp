#include <memory>

#include <fmt/format.h>

#include "runner/cli/corpus_verbs.hpp"
#include "runner/cli/protocol_file.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/corpus/build_corpus.hpp"
#include "stimuli/corpus/spoken_text.hpp"

namespace bimodal::runner {

namespace {

struct BuildOptions {
  BuildRequest request;
  std::vector<std::string> recordings;
  std::string words;
  std::string output;
  std::string text;
  std::string texts;
};

void take_texts(BuildOptions& options) {
  if (!options.texts.empty()) options.request.texts = read_texts(options.texts);
  if (options.text.empty()) return;
  if (options.recordings.size() != 1) {
    throw Error{
        "--text says what is said in one recording; for several, use --texts with a file of "
        "lines \"recording<TAB>words\""};
  }
  const auto name = std::filesystem::path{options.recordings.front()}.stem().string();
  options.request.texts[name] = words_of_text(options.text, "--text");
}

void print_doubts(const Corpus& corpus) {
  for (const auto& item : corpus.items) {
    if (item.doubt.empty()) continue;
    fmt::print("  {:<16} at {:8.2f} s of {}: {}\n",
               item.name,
               std::chrono::duration<double>{item.phones.front().start}.count(),
               corpus.recordings[item.recording].file,
               item.doubt);
  }
}

ExitCode build(BuildOptions options) {
  options.request.folder = options.output;
  options.request.recordings.assign(options.recordings.begin(), options.recordings.end());
  options.request.list = words_named(options.words);
  take_texts(options);
  const auto report = build_corpus(options.request, progress_on_terminal());
  print(report.findings);
  for (const auto& note : report.notes) fmt::print("{}\n", note);
  const auto& items = report.corpus.items;
  if (report.corpus.recordings.empty()) {
    fmt::print(stderr, "bimodal: no recording could be used; there is no corpus\n");
    return ExitCode::InvalidInput;
  }
  const auto doubtful = static_cast<std::size_t>(
      std::ranges::count_if(items, [](const CorpusItem& item) { return !item.doubt.empty(); }));
  const auto unused = static_cast<std::size_t>(
      std::ranges::count(report.findings, Severity::Error, &Diagnostic::severity));
  fmt::print(
      "{}: {} from {}{}\n",
      (options.request.folder / kManifestName).string(),
      counted(items.size(), "item"),
      counted(report.corpus.recordings.size(), "recording"),
      unused == 0 ? "" : fmt::format("; {} could not be used", counted(unused, "recording")));
  if (doubtful > 0) {
    fmt::print("{} to be looked at before {} used:\n",
               counted(doubtful, "item"),
               doubtful == 1 ? "it is" : "they are");
    print_doubts(report.corpus);
    fmt::print(
        "Look at them (`bimodal corpus sheet {0}`, or {0}/labels in Praat); correct the labels "
        "and\n"
        "build again, or accept them: `bimodal corpus accept {0} ITEM...`\n",
        options.output);
  }
  if (has_errors(report.findings)) return ExitCode::InvalidInput;
  return doubtful > 0 || !report.findings.empty() ? ExitCode::Findings : ExitCode::Done;
}

}  // namespace

void add_corpus_build(CLI::App& corpus, Verb& chosen) {
  auto* const verb = corpus.add_subcommand(
      "build",
      "Makes a corpus from recordings (sound, or video with sound) of somebody who reads a list\n"
      "aloud, or whose sentences are known: finds every word, cuts it out with margins, finds its\n"
      "phones. What is doubtful is listed, not silently kept. Labels by hand always win: "
      "NAME.TextGrid\n"
      "(or .lab, .align) beside a recording, or the corpus's own labels/NAME.TextGrid corrected in "
      "Praat.\n"
      "NAME.txt beside a recording says what is said in it, if it is running speech.\n"
      "Exit code: 0 clean, 1 something to look at, 3 a recording could not be used.\n\n"
      "Examples:\n"
      "  bimodal corpus build reading.mp4 --words monosyllables-414 --talker anna -o anna\n"
      "  bimodal corpus build a.mpg b.mpg --texts said.tsv --words words.txt -o sentences\n"
      "  bimodal corpus build --words monosyllables-414 -o anna      after correcting labels");
  auto options = std::make_shared<BuildOptions>();
  verb->add_option("RECORDING",
                   options->recordings,
                   "media files; none: those that the corpus has already, built again");
  verb->add_option("--words",
                   options->words,
                   "which words to take: a word list (.json), the name of one of the project, or a "
                   "text file of words")
      ->required();
  verb->add_option("-o,--output", options->output, "the corpus's folder")->required();
  verb->add_option("--text", options->text, "what is said in the one recording (running speech)");
  verb->add_option("--texts", options->texts, "a file of lines \"recording<TAB>what is said\"");
  auto& request = options->request;
  verb->add_option("--talker", request.talker, "who speaks (the recording's name)");
  verb->add_option("--licence", request.licence, "under which the recordings may be used");
  verb->add_option("--name", request.name, "of the corpus (its folder's name)");
  verb->add_option("--description", request.description, "of the corpus");
  verb->add_option("--eye-distance",
                   request.eye_distance_px,
                   "distance of the outer eye corners in the picture, in pixels")
      ->check(CLI::Range(1.0, 10'000.0));
  verb->callback([options, &chosen] { chosen = [options] { return build(*options); }; });
}

}  // namespace bimodal::runner

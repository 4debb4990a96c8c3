#include <memory>

#include <fmt/format.h>

#include "runner/cli/corpus_verbs.hpp"
#include "runner/cli/option_checks.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/corpus/contact_sheet.hpp"

namespace bimodal::runner {

namespace {

struct SheetOptions {
  std::string corpus;
  std::string output = "sheet.png";
  bool doubtful = false;
};

ExitCode sheet(const SheetOptions& options) {
  auto corpus = open_corpus(options.corpus);
  if (options.doubtful) {
    std::erase_if(corpus.items, [](const CorpusItem& item) { return item.doubt.empty(); });
  }
  const auto drawn = draw_contact_sheet(corpus, options.output, progress_on_terminal());
  for (const auto& finding : drawn.findings) fmt::print(stderr, "bimodal: {}\n", finding);
  for (const auto& file : drawn.files) fmt::print("{}\n", file.string());
  fmt::print(
      "{} on {}\n", counted(corpus.items.size(), "item"), counted(drawn.files.size(), "page"));
  return drawn.findings.empty() ? ExitCode::Done : ExitCode::Findings;
}

}  // namespace

void add_corpus_sheet(CLI::App& corpus, Verb& chosen) {
  auto* const verb = corpus.add_subcommand("sheet",
                                           "Draws every item: first frame, the frame in the middle "
                                           "of the vowel, last frame; below, the\n"
                                           "sound wave from start to end with the edges of the "
                                           "phones. Red: doubtful. Grey: a neighbouring\n"
                                           "word. Several pages are NAME-1.png, NAME-2.png, ...\n\n"
                                           "Examples:\n"
                                           "  bimodal corpus sheet anna -o anna.png\n"
                                           "  bimodal corpus sheet anna --doubtful");
  auto options = std::make_shared<SheetOptions>();
  verb->add_option("CORPUS", options->corpus, "a folder with corpus.json")->required();
  verb->add_option("-o,--output", options->output, "the picture (sheet.png)")
      ->check(in_a_folder_that_exists());
  verb->add_flag("--doubtful", options->doubtful, "only doubtful items");
  verb->callback([options, &chosen] { chosen = [options] { return sheet(*options); }; });
}

}  // namespace bimodal::runner

#include <memory>
#include <utility>

#include <fmt/format.h>

#include "runner/cli/corpus_verbs.hpp"
#include "stimuli/base/counted.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

struct AcceptOptions {
  std::string corpus;
  std::vector<std::string> items;
  bool all = false;
};

ExitCode accept(const AcceptOptions& options) {
  if (options.all != options.items.empty()) {
    throw Error{"name the items to be accepted, or give --all, not both"};
  }
  auto corpus = open_corpus(options.corpus);
  for (const auto& name : options.items) {
    if (std::ranges::find(corpus.items, name, &CorpusItem::name) != corpus.items.end()) continue;
    throw Error{fmt::format("there is no item '{}' in '{}'; `bimodal corpus list {}` names them",
                            name,
                            options.corpus,
                            options.corpus)};
  }
  std::size_t accepted = 0;
  for (auto& item : corpus.items) {
    const bool meant =
        options.all || std::ranges::find(options.items, item.name) != options.items.end();
    if (!meant) continue;
    if (item.doubt.empty()) {
      if (!options.all) fmt::print("{}: has no doubt, so there is nothing to accept\n", item.name);
      continue;
    }
    fmt::print("{}: accepted although {}\n", item.name, item.doubt);
    item.accepted = std::exchange(item.doubt, {});
    ++accepted;
  }
  if (accepted > 0) write_corpus(corpus);
  fmt::print("{} accepted\n", counted(accepted, "item"));
  return ExitCode::Done;
}

}  // namespace

void add_corpus_accept(CLI::App& corpus, Verb& chosen) {
  auto* const verb = corpus.add_subcommand(
      "accept",
      "Takes the doubt from items that somebody has looked at. It stays away when the corpus is "
      "built\n"
      "again, as long as the item and the doubt come out the same.\n\n"
      "Examples:\n  bimodal corpus accept anna stew-2 blue\n  bimodal corpus accept anna --all");
  auto options = std::make_shared<AcceptOptions>();
  verb->add_option("CORPUS", options->corpus, "a folder with corpus.json")->required();
  verb->add_option("ITEM", options->items, "names of items");
  verb->add_flag("--all", options->all, "every item of the corpus");
  verb->callback([options, &chosen] { chosen = [options] { return accept(*options); }; });
}

}  // namespace bimodal::runner

#pragma once

#include <functional>
#include <string_view>

#include "runner/cli/verbs.hpp"
#include "stimuli/corpus/corpus.hpp"
#include "stimuli/corpus/hear_list.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal::runner {

// Each adds one sub-verb of `corpus`.
void add_corpus_record(CLI::App& corpus, Verb& chosen);
void add_corpus_build(CLI::App& corpus, Verb& chosen);
void add_corpus_check(CLI::App& corpus, Verb& chosen);
void add_corpus_list(CLI::App& corpus, Verb& chosen);
void add_corpus_sheet(CLI::App& corpus, Verb& chosen);
void add_corpus_accept(CLI::App& corpus, Verb& chosen);

/// The corpus at a place that the user names. Prints every mistake of its manifest; throws Error if
/// it cannot be used for that.
[[nodiscard]] Corpus open_corpus(const std::string& place);

/// The words that the user means: a word list (.json) or its name among those of the project
/// ("monosyllables-414"), or a plain text of words, whose pronunciations the dictionary knows.
/// Throws Error, with all mistakes, if it cannot be used.
[[nodiscard]] WordList words_named(const std::string& named);

/// Shows on standard error how far a long work is, at most once in a tenth of its way, and nothing
/// unless that is a terminal.
[[nodiscard]] Progress progress_on_terminal();

}  // namespace bimodal::runner

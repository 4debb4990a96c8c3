#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "protocols/model/face_terms.hpp"
#include "protocols/model/protocol.hpp"
#include "protocols/reading/casting.hpp"
#include "stimuli/base/diagnostic.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal::protocols {

/// A protocol and everything that was found in reading it. Only to be run if
/// !has_errors(diagnostics).
struct ReadProtocol {
  Protocol protocol;
  WordList words;              ///< the main list; name: as the protocol names it
  std::vector<Word> practice;  ///< protocol.practice.words with their pronunciations
  std::string text;            ///< the file's very content
  std::string sha256;          ///< of the text
  std::vector<std::string> condition_pointers;  ///< where each of protocol.conditions is written
  std::map<std::string, Corpus> corpora;        ///< that the talkers "corpus:NAME" are, by NAME
  CastOptions cast;                             ///< what was chosen in reading
  /// Every mistake and warning: of the corpora, of the protocol in the order of its lines, then of
  /// its and word lists.
  std::vector<Diagnostic> diagnostics;
};

struct ReadOptions {
  std::filesystem::path dictionary;  ///< CMU format; empty: Dictionary::installed()
  CastOptions cast;
  FaceTerms face;  ///< what a protocol may ask of the synthetic face
};

/// Reads a protocol (key by key in protocols/README.md) and every word list that it names, and
/// judges them whole. Does not throw for anything that a file may contain; a missing or unreadable
/// file is a diagnostic too. Untrusted input: see kLargestFile, kDeepestNesting, kMostValues.
[[nodiscard]] ReadProtocol read_protocol(const std::filesystem::path& file,
                                         const ReadOptions& options = {});

/// The same for a text; `file` is its name in diagnostics, and word lists are looked for beside it.
[[nodiscard]] ReadProtocol read_protocol_text(std::string text,
                                              const std::filesystem::path& file,
                                              const ReadOptions& options = {});

}  // namespace bimodal::protocols

#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "protocols/reading/structure.hpp"
#include "stimuli/base/findings.hpp"
#include "stimuli/words/dictionary.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal::protocols {

/// Turns what a protocol asks for into words with pronunciations. The dictionary is opened when the
/// first spelled-out word needs it; a failure to open it is noted once.
class WordFinder {
 public:
  /// `protocol_folder`: what paths of word lists are relative to. `dictionary`: a file in CMU
  /// format; empty for Dictionary::installed(). `findings` is borrowed.
  WordFinder(std::filesystem::path protocol_folder,
             std::filesystem::path dictionary,
             Findings& findings);

  /// The words of a list, or those spelled out, each with its most common pronunciation. Words that
  /// have none are noted and left out.
  [[nodiscard]] std::vector<Word> find(const WordChoice& choice);

  /// What the word lists themselves have wrong, with their own file names and lines.
  [[nodiscard]] const std::vector<Diagnostic>& list_findings() const { return list_findings_; }

 private:
  [[nodiscard]] std::vector<Word> look_up(const WordChoice& choice);
  [[nodiscard]] std::optional<SpelledSegments> pronounce(const std::string& spelling,
                                                         const std::string& pointer);
  [[nodiscard]] std::vector<Word> read_list(const WordChoice& choice);
  [[nodiscard]] const Dictionary* dictionary(std::string_view pointer);

  std::filesystem::path folder_;
  std::filesystem::path dictionary_file_;
  Findings* findings_;
  std::optional<Dictionary> dictionary_;
  bool dictionary_failed_ = false;
  std::vector<Diagnostic> list_findings_;
};

}  // namespace bimodal::protocols

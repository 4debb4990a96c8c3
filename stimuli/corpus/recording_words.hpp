#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "stimuli/corpus/corpus_folder.hpp"
#include "stimuli/corpus/hear_list.hpp"
#include "stimuli/corpus/spoken_text.hpp"

namespace bimodal {

/// The texts that are known, by the recording's name without folder and ending.
using Texts = std::map<std::string, std::vector<std::string>>;

/// What is said where in a recording, and how that is known.
struct RecordingWords {
  SaidWords said;
  /// Running speech of known words: what somebody has written down; absent elsewhere.
  std::optional<std::vector<std::string>> text;
  std::filesystem::path labels;  ///< the hand's, which were used; empty: none
  bool by_list = false;          ///< heard as the list, read aloud word by word
};

/// Finds the words of recordings by the first of: the corpus's own labels, if somebody has changed
/// them; labels beside the recording (NAME.TextGrid, .lab, .align); a text given, beside the
/// recording (NAME.txt) or kept in the corpus; the list, read aloud.
class RecordingReader {
 public:
  /// All arguments are borrowed for as long as the reader is used.
  RecordingReader(std::span<const Word> list,
                  const Texts& texts,
                  const CorpusLabels& labels,
                  Pronouncer& pronouncer,
                  const Progress& progress);

  /// Throws Error where labels or texts cannot be used, or there is no speech.
  [[nodiscard]] RecordingWords read(const std::filesystem::path& recording, const Clip& sound);

 private:
  [[nodiscard]] RecordingWords labelled(const std::filesystem::path& labels, const Clip& sound);
  [[nodiscard]] std::optional<std::vector<std::string>> text_of(
      const std::filesystem::path& recording) const;

  std::span<const Word> list_;
  const Texts* texts_;
  const CorpusLabels* labels_;
  Pronouncer* pronouncer_;
  const Progress* progress_;
};

}  // namespace bimodal

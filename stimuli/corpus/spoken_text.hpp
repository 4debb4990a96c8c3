#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/alignment/aligner.hpp"
#include "stimuli/words/dictionary.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal {

/// The words of a text that somebody wrote down: lower case, punctuation left out but for
/// apostrophes and hyphens within a word. Throws Error, naming `source`, if it is not UTF-8, holds
/// control characters, has no words, or more than 5000.
[[nodiscard]] std::vector<std::string> words_of_text(std::string_view text,
                                                     const std::string& source);

/// As words_of_text, from a file. Throws Error if it cannot be read or is longer than 1 MB.
[[nodiscard]] std::vector<std::string> read_text(const std::filesystem::path& file);

/// What is said in which recording: lines "recording-name<TAB>words"; empty lines and lines that
/// begin with "#" do not count. The key is the recording's name without folder and ending. Throws
/// Error, naming file and line, if a line has no tab or no words, a recording stands twice, or as
/// read_text.
[[nodiscard]] std::map<std::string, std::vector<std::string>> read_texts(
    const std::filesystem::path& file);

/// The same, from the file's content.
[[nodiscard]] std::map<std::string, std::vector<std::string>> parse_texts(
    std::string_view content, const std::string& source);

/// How words are said: a word of the list as the list says, any other in every way that the
/// dictionary knows.
class Pronouncer {
 public:
  explicit Pronouncer(std::span<const Word> list);

  [[nodiscard]] bool is_listed(std::string_view word) const;

  /// Absent if the word is in neither; the dictionary is read when it is first needed.
  [[nodiscard]] std::optional<SpokenWord> find(const std::string& word);

  /// As find, but throws Error if the word is in neither, saying where it can be written down.
  [[nodiscard]] SpokenWord pronounce(const std::string& word);

 private:
  std::map<std::string, Pronunciation, std::less<>> list_;
  std::optional<Dictionary> dictionary_;
};

}  // namespace bimodal

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/timeline/phone.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal {

/// One pronunciation of a spelling.
struct DictionaryEntry {
  std::string spelling;  ///< lower case
  Pronunciation phones;
};

/// Spellings and how they are said: the CMU Pronouncing Dictionary as pocketsphinx-en-us installs
/// it.
class Dictionary {
 public:
  /// Reads a dictionary in CMU format ("stew S T UW", "read(2) R IY D"). Throws Error, naming file
  /// and line.
  explicit Dictionary(const std::filesystem::path& file);

  /// Of these entries, in any order; of several of one spelling the most common first.
  explicit Dictionary(std::vector<DictionaryEntry> entries);

  /// $BIMODAL_DICTIONARY, or where Debian's pocketsphinx-en-us puts it. Throws Error saying what to
  /// install if it is not there.
  [[nodiscard]] static std::filesystem::path installed();

  /// All pronunciations of a spelling (lower case), the most common first; empty if it is unknown.
  [[nodiscard]] std::span<const Pronunciation> pronunciations(std::string_view spelling) const;

  /// Whether two spellings share a pronunciation. A spelling is its own homophone, known or not.
  [[nodiscard]] bool homophones(std::string_view one, std::string_view other) const;

  /// Every spelling, sorted.
  [[nodiscard]] std::span<const std::string> spellings() const;

 private:
  std::vector<std::string> spellings_;
  std::vector<Pronunciation> pronunciations_;  ///< of the first spelling, of the second, ...
  std::vector<std::size_t> begins_;            ///< where a spelling's begin; one more for the end
};

/// Whether there is exactly one vowel.
[[nodiscard]] bool is_one_syllable(std::span<const Phone> phones);

}  // namespace bimodal

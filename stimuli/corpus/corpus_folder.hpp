#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "stimuli/labels/labels.hpp"

namespace bimodal {

/// The folder labels/ of a corpus: what we wrote there, and what somebody has changed since.
class CorpusLabels {
 public:
  /// Reads labels/written.json, if there is one; a damaged one counts as none, so that every label
  /// file is taken for the hand's. The folder is made when something is written.
  explicit CorpusLabels(const std::filesystem::path& corpus);

  [[nodiscard]] std::filesystem::path file_of(const std::string& recording) const;

  /// What is said in a recording of running speech.
  [[nodiscard]] std::filesystem::path text_file_of(const std::string& recording) const;

  /// Whether there are labels that are not the ones that we wrote.
  [[nodiscard]] bool edited(const std::string& recording) const;

  /// Writes the labels of a recording and notes their digest. Precondition: not edited.
  void write(const std::string& recording, const Labels& labels);

  void write_text(const std::string& recording, std::span<const std::string> words);

 private:
  std::filesystem::path folder_;
  std::map<std::string, std::string> written_;  ///< file name to SHA-256
};

/// Puts a recording's very bytes into the media/ of a corpus (hard link, otherwise copy) unless it
/// is there already, and returns its path within the corpus. Throws Error if another file of that
/// name is there, or it cannot be written.
[[nodiscard]] std::string take_media(const std::filesystem::path& recording,
                                     const std::filesystem::path& corpus);

}  // namespace bimodal

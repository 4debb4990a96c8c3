#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/base/diagnostic.hpp"
#include "stimuli/corpus/corpus.hpp"
#include "stimuli/corpus/recording_words.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal {

/// What a corpus is to be built from. Options that are absent keep what an earlier manifest in the
/// folder says.
struct BuildRequest {
  std::filesystem::path folder;
  std::vector<std::filesystem::path> recordings;  ///< empty: those that the folder has already
  WordList list;                                  ///< which words become items
  Texts texts;                                    ///< what is said in running speech
  std::optional<std::string> talker;
  std::optional<std::string> licence;
  std::optional<std::string> name;
  std::optional<std::string> description;
  std::optional<double> eye_distance_px;
};

/// What came of it.
struct BuildReport {
  Corpus corpus;
  /// Errors: recordings that could not be taken. Warnings: words that are missing, speech that is
  /// none of the words, and the like; each with the recording as its file.
  std::vector<Diagnostic> findings;
  /// What nobody need do anything about: words of running speech that are not in the list.
  std::vector<std::string> notes;
};

/// Builds a corpus in a folder, which is made if need be:
///   media/NAME.*         the recordings: hard links where the file system allows it, otherwise
///                        copies; never re-encoded
///   sound/NAME.wav       the sound of video recordings, for Praat, which reads no video
///   labels/NAME.TextGrid words and phones, for looking at and correcting in Praat
///   labels/NAME.txt      what is said, of running speech
///   labels/written.json  SHA-256 of the TextGrids as they were written
///   corpus.json          the manifest
///
/// What is said where, RecordingReader finds; labels/NAME.TextGrid is never overwritten once
/// somebody has changed it.
///
/// Recordings and items of an earlier manifest that are not built again are kept, and so is the
/// acceptance of an item that comes out the same as before with the same doubt. A recording that
/// cannot be used is an error among the findings, its earlier items are doubted, and the others are
/// built all the same. Throws Error if the
/// folder cannot be written, or two recordings have the same name.
[[nodiscard]] BuildReport build_corpus(const BuildRequest& request, const Progress& progress = {});

}  // namespace bimodal

#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/base/diagnostic.hpp"
#include "stimuli/base/quantity.hpp"
#include "stimuli/timeline/utterance.hpp"

namespace bimodal {

/// One media file of a corpus.
struct Recording {
  std::string file;     ///< relative to the corpus's folder, "media/reading.mp4"
  std::string sha256;   ///< of its bytes
  std::string talker;   ///< who speaks, as the laboratory names people
  std::string licence;  ///< under which it may be used
  /// Distance of the outer eye corners in the picture as shown (upright, square pixels); absent:
  /// not measured. It tells the size of the head where talkers are to be matched.
  std::optional<double> eye_distance_px;

  bool operator==(const Recording&) const = default;
};

/// One thing that the talker says: a word (or a text), where it stands in its recording, and when
/// each phone sounds.
struct CorpusItem {
  std::string name;           ///< unique within the corpus: "stew", "stew-2"
  std::string word;           ///< what is said, lower case
  std::size_t recording = 0;  ///< index into Corpus::recordings
  Duration start{};           ///< of the item with its margins, from the zero of the recording
  Duration end{};
  /// In order, without gaps, from the zero of the recording, within start and end; the first and
  /// the last are no rest.
  std::vector<TimedPhone> phones;
  /// Where nothing but this word is heard, if that is less than from start to end: words cut out of
  /// running speech have their neighbours in their margins. Within start and end.
  std::optional<SpeechInterval> clear;
  std::string doubt;     ///< why somebody should look at it before it is used; empty: no doubt
  std::string accepted;  ///< the doubt in spite of which somebody has accepted it; empty: none

  bool operator==(const CorpusItem&) const = default;
};

/// A talker, or several, saying a list of words: a folder with media files and corpus.json.
struct Corpus {
  std::string name;
  std::string description;
  std::filesystem::path folder;
  std::string sha256;  ///< of corpus.json as it was read; empty: not read from a file
  std::vector<Recording> recordings;
  std::vector<CorpusItem> items;
};

/// The format of the manifests that this program reads and writes: their key "bimodal_corpus".
inline constexpr int kManifestFormat = 1;

/// The name of the manifest in a corpus's folder.
inline constexpr std::string_view kManifestName = "corpus.json";

/// Reads a corpus, given its folder or its manifest; every key is explained in
/// stimuli/corpus/README.md. The manifest is not trusted: appends every mistake (not JSON, unknown
/// phone, times out of order or outside the item, a path that leaves the folder, doubled names, a
/// recording that is named nowhere, ...) to `diagnostics` and returns what could be read. The media
/// are not opened.
[[nodiscard]] Corpus read_corpus(const std::filesystem::path& place,
                                 std::vector<Diagnostic>& diagnostics);

/// As read_corpus, from the manifest's text; `file` is its name in messages.
[[nodiscard]] Corpus parse_corpus(std::string_view text,
                                  const std::filesystem::path& file,
                                  std::vector<Diagnostic>& diagnostics);

/// Writes the manifest into corpus.folder, one line an item; times are rounded to microseconds.
/// Atomic. Throws Error if it cannot be written.
void write_corpus(const Corpus& corpus);

/// The item that says a word: the first without doubt, or, if there is none, nothing.
[[nodiscard]] const CorpusItem* find_item(const Corpus& corpus, std::string_view word);

/// The phones, counted from the item's start, with rest before, after and filling its margins; may
/// lack the rest where an item has no margin.
[[nodiscard]] Utterance utterance_of(const CorpusItem& item);

/// The phones without their times, rest left out.
[[nodiscard]] Pronunciation pronunciation_of(const CorpusItem& item);

/// Where the media file of a recording is.
[[nodiscard]] std::filesystem::path media_file(const Corpus& corpus, std::size_t recording);

}  // namespace bimodal

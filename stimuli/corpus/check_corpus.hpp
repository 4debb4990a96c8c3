#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "stimuli/corpus/corpus.hpp"
#include "stimuli/corpus/hear_list.hpp"
#include "stimuli/corpus/item_sound.hpp"
#include "stimuli/video/media_file.hpp"
#include "stimuli/words/word_list.hpp"

namespace bimodal {

/// The frames of the picture that an item shows.
struct ItemFrames {
  std::size_t count = 0;
  std::size_t uneven = 0;   ///< last more than a quarter longer or shorter than the median frame
  std::size_t doubled = 0;  ///< the same, pixel for pixel, as the one before
};

/// What was found about one item.
struct ItemCheck {
  std::optional<ItemSound> sound;  ///< absent: could not be decoded
  Duration before{};               ///< margins, see CorpusItem
  Duration after{};
  std::optional<ItemFrames> frames;   ///< absent: no picture, or not decoded
  std::vector<std::string> findings;  ///< to be looked at
  std::vector<std::string> errors;    ///< cannot be presented
};

struct RecordingCheck {
  std::optional<Media> media;  ///< absent: not there or no media file
  /// How much later than the picture the sound begins and ends, by the time stamps in the file.
  /// That what is heard belongs to what is seen was not measured: time stamps can be wrong.
  std::optional<Duration> sound_begins_later;
  std::optional<Duration> sound_ends_later;
  std::vector<std::string> findings;
  std::vector<std::string> errors;
};

/// Everything about a finished corpus; recordings and items in the manifest's order.
struct CorpusCheck {
  std::vector<RecordingCheck> recordings;
  std::vector<ItemCheck> items;
  std::optional<Decibels> median_level;  ///< of the items' speech; absent: of none
  std::optional<double> level_sd_db;     ///< absent: fewer than two items
  std::vector<std::string> missing;      ///< words of the list without an item that can be used
  std::vector<std::string> doubled;      ///< words with several items that can be used

  [[nodiscard]] std::size_t findings() const;  ///< missing words among them, doubled ones not
  [[nodiscard]] std::size_t errors() const;
};

/// Looks at every recording (there, unchanged, its tracks' rates and starts) and at every item
/// (decodes its sound and all its frames; level, clipping, margins, frames that are uneven or
/// doubled, doubts). Throws nothing for what is wrong with the corpus.
[[nodiscard]] CorpusCheck check_corpus(const Corpus& corpus,
                                       std::span<const Word> list = {},
                                       const Progress& progress = {});

}  // namespace bimodal

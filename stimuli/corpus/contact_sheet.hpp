#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stimuli/corpus/corpus.hpp"
#include "stimuli/corpus/hear_list.hpp"

namespace bimodal {

/// The pages that were written, and which items could not be drawn whole, and why.
struct ContactSheet {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> findings;
};

/// Draws every item of a corpus as a cell: first frame, the frame in the middle of its (first)
/// vowel, last frame; below, the name and the phones; below that the sound wave from the item's
/// start to its end, at the same scale of time and level for all, with the edges of the phones.
/// Items in doubt have a red name and the doubt below it; what is not clear of other words is grey.
/// Of sound alone, the waves are drawn alone. At most 48 items stand on a page; where there are
/// several pages, "-1", "-2" and so on is put before the ending of `file`.
///
/// Throws Error if a page cannot be written or there are no items.
[[nodiscard]] ContactSheet draw_contact_sheet(const Corpus& corpus,
                                              const std::filesystem::path& file,
                                              const Progress& progress = {});

}  // namespace bimodal

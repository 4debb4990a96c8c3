#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "stimuli/labels/labels.hpp"

namespace bimodal {

/// Reads a label file; its name's ending tells the format, and what stands in it is verified:
///   .TextGrid     Praat, long and short text; UTF-8, UTF-16 (either order) or Latin-1
///   .lab          HTK ("0 2300000 sil", 100 ns) or Festival/Xwaves ("#", then "0.25 100 pau"),
///   told
///                 apart by their lines
///   .align        GRID ("0 23750 sil", 25000 to the second)
///   .csv          a header with start_s,end_s,text and, if there are several, tier; RFC 4180
/// The file is not trusted: throws Error, naming the file, the line, what was found and the remedy,
/// if it is too large (16 MB), has too many labels (200,000), is of another kind, or holds times
/// that are not finite, negative, out of order or overlapping.
[[nodiscard]] Labels read_labels(const std::filesystem::path& file);

/// As read_labels, from a text; `name` is the file's name for its ending and for messages.
[[nodiscard]] Labels parse_labels(std::string_view bytes, const std::string& name);

/// Writes a Praat TextGrid (long text, UTF-8), each tier filled with empty intervals to the whole
/// length, or by its ending a .lab (HTK), .align or .csv file; .lab and .align hold one tier, the
/// first. Atomic, as write_wav. Throws Error if it cannot be written.
void write_labels(const std::filesystem::path& file, const Labels& labels);

}  // namespace bimodal

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "stimuli/labels/labels.hpp"

namespace bimodal {

/// Reads a label file; its name's ending, in any case, tells the format, and what stands in it is
/// verified:
///   .TextGrid  Praat, long and short text; points are labels of no length
///   .lab       HTK ("0 2300000 sil", 100 ns) or Festival/Xwaves ("#", then "0.25 100 pau"), told
///              apart by the line "#"; the tier is "phones" if all labels are, otherwise "words"
///   .align     GRID ("0 23750 sil", 25000 to the second); the tier is "words"
///   .csv       a header with start_s,end_s,text and, if there are several, tier; RFC 4180
/// The text may be UTF-8, UTF-16 (either order, with a byte order mark) or Latin-1; lines may end
/// as on any system.
///
/// Labels without text that have a length are gaps and left out: Labels::end keeps the length,
/// which for all but TextGrids is the end of the last line. Labels that overlap by up to 1 us are
/// taken for rounded, and the later one is shortened.
///
/// The file is not trusted: throws Error, naming the file, the line, what was found and the remedy,
/// if it is too large (16 MB), has too many labels (200,000), is of another kind, or holds times
/// that are not finite, negative, beyond 1,000,000 s, out of order or overlapping.
[[nodiscard]] Labels read_labels(const std::filesystem::path& file);

/// As read_labels, from a text; `name` is the file's name for its ending and for messages.
[[nodiscard]] Labels parse_labels(std::string_view bytes, const std::string& name);

/// Writes, by the ending of the name, a Praat TextGrid (long text, UTF-8; tiers of points only as
/// point tiers, others filled with empty intervals to the whole length), a .lab (HTK), .align or
/// .csv file. TextGrid and CSV give back to read_labels what was written; .lab (rounded to 100 ns)
/// and .align (to 40 us) hold one tier, the first, without its name, up to the end of its last
/// label. Atomic, as write_wav. Throws Error, naming the file, if it cannot be written, if the
/// labels do not keep the promises of Labels, or if the format cannot hold them: .lab and .align no
/// tier without labels, .align no text that is empty or has line breaks, CSV no two tiers of one
/// name.
void write_labels(const std::filesystem::path& file, const Labels& labels);

/// Whether the format that the ending of a name tells, .lab or .align, holds one tier only. Throws
/// Error if it tells none.
[[nodiscard]] bool holds_one_tier(const std::filesystem::path& file);

}  // namespace bimodal

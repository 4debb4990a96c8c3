#pragma once

#include <string>
#include <string_view>

#include "stimuli/labels/labels.hpp"

namespace bimodal {

/// Reads a Praat TextGrid, long or short, from UTF-8 with '\n' (see decode_text). Points are labels
/// of no length. Throws Error, naming the line, as read_labels.
[[nodiscard]] Labels parse_text_grid(std::string_view text, std::string_view file);

/// The long text form. A tier of points only is a TextTier; any other is an IntervalTier from 0 to
/// the end, its gaps filled with empty intervals.
[[nodiscard]] std::string text_grid(const Labels& labels);

}  // namespace bimodal

#pragma once

#include <string>
#include <string_view>

#include "stimuli/labels/labels.hpp"

namespace bimodal {

/// Reads a .align file of the GRID corpus (Cooke, Barker, Cunningham & Shao 2006) from UTF-8 with
/// '\n' (see decode_text): lines of start, end and word, 25000 units to the second (a thousand to a
/// frame of the video). The tier is called "words". Throws Error, naming the line, as read_labels.
[[nodiscard]] Labels parse_align(std::string_view text, std::string_view file);

/// The same form. Texts are not empty and have no line breaks.
[[nodiscard]] std::string align_text(const Tier& tier);

}  // namespace bimodal

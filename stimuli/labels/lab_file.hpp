#pragma once

#include <string>
#include <string_view>

#include "stimuli/labels/labels.hpp"

namespace bimodal {

/// Reads a .lab file from UTF-8 with '\n' (see decode_text); the tier is named by its content.
///
/// With a line "#" it is of Festival, that is of ESPS/Xwaves: a heading up to "#", then lines of
/// the end in seconds, a colour and a text; a label begins where the one before it ends, the first
/// at 0. Of several fields, separated by the heading's "separator" (";"), the first is the text.
/// Otherwise it is of HTK (The HTK Book 3.4, section 6.2.1): lines of start and end in 100 ns and a
/// name, which may be quoted and have escapes; scores and further names behind it are not read.
/// Throws Error, naming the line, as read_labels.
[[nodiscard]] Labels parse_lab(std::string_view text, std::string_view file);

/// The HTK form. Names that need it are quoted.
[[nodiscard]] std::string htk_lab(const Tier& tier);

}  // namespace bimodal

#pragma once

#include <string>
#include <string_view>

#include "stimuli/labels/labels.hpp"

namespace bimodal {

/// Reads labels from CSV (RFC 4180) in UTF-8 with '\n' (see decode_text). The first line names the
/// columns: start_s, end_s (seconds), text, perhaps tier, in any order; others are not read. Tiers
/// stand in the order of their first rows; without that column there is one, named by its content.
/// A row without text extends the tier to its end. Throws Error, naming the line, as read_labels.
[[nodiscard]] Labels parse_csv_labels(std::string_view text, std::string_view file);

/// The columns tier,start_s,end_s,text. A tier that ends before the recording has a last row
/// without text up to its end.
[[nodiscard]] std::string csv_labels(const Labels& labels);

}  // namespace bimodal

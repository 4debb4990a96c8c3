#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "runner/monitor/tally.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

// Pieces of a screen of text. A character (code point) counts as one column wide.

/// What a terminal shows and does not act on: control characters (C0, DEL, C1) become '?'.
[[nodiscard]] std::string harmless(std::string_view text);

/// Exactly `width` columns: cut with "..", or filled with blanks.
[[nodiscard]] std::string fitted(std::string_view text, std::size_t width);

/// `left` and `right` at the ends of a row of `width`; `left` is cut if need be.
[[nodiscard]] std::string apart(std::string_view left, std::string_view right, std::size_t width);

/// "1:02:03", "2:03": rounded down to whole seconds.
[[nodiscard]] std::string clock_text(Duration duration);

/// "about 29 min", "about 1 h 10 min", "less than a minute".
[[nodiscard]] std::string rough_text(Duration duration);

/// "[#####-----]" of `width` columns.
[[nodiscard]] std::string bar(std::size_t done, std::size_t of, std::size_t width);

/// The table of main trials by condition, with headings, at most `rows` rows: if there are more
/// conditions, the last row says how many. Where a condition has no trial that could be judged, no
/// percentage.
[[nodiscard]] std::vector<std::string> condition_table(const std::vector<ConditionTally>& tallies,
                                                       std::size_t rows);

}  // namespace bimodal::runner

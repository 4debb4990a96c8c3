#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace bimodal::analysis {

/// White at 0 to dark blue at 1, lightness falling evenly: the sequential scheme "Blues" of
/// ColorBrewer (Brewer, 2003), safe for the colour-blind and in grey print. "#rrggbb".
[[nodiscard]] std::string sequential_colour(double share);

/// Dark brown at -1, white at 0, dark purple at 1: the diverging scheme "PuOr" of ColorBrewer, safe
/// for the colour-blind.
[[nodiscard]] std::string diverging_colour(double share);

/// What can be read on this colour: black or white, whichever contrasts more (relative luminance
/// of WCAG 2.1).
[[nodiscard]] std::string_view ink_on(std::string_view colour);

/// Colours for conditions side by side that people with any colour vision tell apart on white
/// (Okabe & Ito, 2008).
[[nodiscard]] std::string series_colour(std::size_t index);

}  // namespace bimodal::analysis

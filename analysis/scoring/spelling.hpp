#pragma once

#include <string>
#include <string_view>

namespace bimodal::analysis {

/// A typed answer as it is compared and looked up: lower case; accents of Latin-1 and Latin
/// Extended-A taken off (also combining ones); space, punctuation and symbols left out wherever
/// they stand; the various apostrophes written ' and kept only between letters. Other scripts are
/// kept as they are. Empty if nothing is left: " ?!" is as blank as "".
[[nodiscard]] std::string fold_spelling(std::string_view utf8);

}  // namespace bimodal::analysis

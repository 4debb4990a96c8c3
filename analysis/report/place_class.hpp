#pragma once

#include <string_view>

namespace bimodal::analysis {

/// The group within which the symbols of a figure stand together: a consonant's place ("bilabial",
/// "alveolar", ...), a vowel's region ("front", "central", "back") or "diphthong"; for what is no
/// phone, "no phone".
[[nodiscard]] std::string_view place_class(std::string_view symbol);

}  // namespace bimodal::analysis

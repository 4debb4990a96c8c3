#pragma once

#include <filesystem>
#include <string_view>

namespace bimodal {

/// Where a file that the project ships is, named by its path in the project, e.g.
/// asset("stimuli/assets/words/monosyllables-414.json"). Looked for below $BIMODAL_ROOT, then below
/// ../share/bimodal beside the program, then in the source tree that the program was built from.
/// Throws Error, listing the places, if it is in none of them.
[[nodiscard]] std::filesystem::path asset(std::string_view path_in_project);

}  // namespace bimodal

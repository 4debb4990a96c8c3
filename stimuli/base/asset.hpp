#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bimodal {

/// Where a file that the project ships is, named by its path in the project, e.g.
/// asset("stimuli/assets/words/monosyllables-414.json"). Looked for below $BIMODAL_ROOT, then below
/// ../share/bimodal beside the program, then in the source tree that the program was built from.
/// Throws Error, listing the places, if it is in none of them.
[[nodiscard]] std::filesystem::path asset(std::string_view path_in_project);

/// The names, without their extension, of the files that the project ships in a folder and that end
/// with `extension` (".json"); in order. Throws Error as asset() does.
[[nodiscard]] std::vector<std::string> asset_names(std::string_view folder_in_project,
                                                   std::string_view extension);

}  // namespace bimodal

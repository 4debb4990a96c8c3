#pragma once

#include <filesystem>
#include <string>

namespace bimodal {

/// The file of an inventory of segments, what the synthetic face articulates: a file, relative to
/// `folder` (empty: the current one), or one that ships with the program by its name ("english" or
/// "english.json"). Throws Error naming those if there is neither, or if the file cannot be opened.
[[nodiscard]] std::filesystem::path inventory_file(const std::string& chosen,
                                                   const std::filesystem::path& folder = {});

}  // namespace bimodal

#pragma once

#include <filesystem>
#include <string_view>

namespace bimodal {

/// Writes a whole file: beside `file` under another name, then renamed, so that `file` is never
/// half there. Throws Error, naming it, if it cannot be written.
void write_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace bimodal

#pragma once

#include <filesystem>
#include <string>

#include "runner/cli/verbs.hpp"

namespace bimodal::runner {

/// The file of an inventory: a file as it is, or one that ships by its name. Throws Error if there
/// is neither.
[[nodiscard]] std::filesystem::path segments_file(const std::string& chosen);

void add_segments_show(CLI::App& segments, Verb& chosen);

}  // namespace bimodal::runner

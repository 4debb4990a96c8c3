#pragma once

#include <filesystem>
#include <string>

namespace bimodal::runner {

/// The file of an inventory of segments: a file as it is, or one that ships by its name
/// ("english"). Throws Error if there is neither.
[[nodiscard]] std::filesystem::path segments_file(const std::string& chosen);

}  // namespace bimodal::runner

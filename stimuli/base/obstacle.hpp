#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace bimodal {

/// Why a file that somebody named should not even be opened: it is missing, a folder, a device or a
/// pipe (reading might never end), or larger than kLargestFile. Absent if nothing stands against
/// it.
[[nodiscard]] std::optional<std::string> obstacle(const std::filesystem::path& file);

}  // namespace bimodal

#pragma once

#include <span>
#include <string>
#include <string_view>

namespace bimodal::analysis {

/// A command as it can be typed into a POSIX shell: words with anything but plain letters, digits
/// and a few signs stand in apostrophes.
[[nodiscard]] std::string command_line(std::string_view program,
                                       std::span<const std::string> arguments);

}  // namespace bimodal::analysis

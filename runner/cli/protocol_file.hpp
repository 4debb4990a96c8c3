#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "protocols/reading/read_protocol.hpp"

namespace bimodal::runner {

/// The file that the user means: a path, or the name of a protocol of the library ("words414").
[[nodiscard]] std::filesystem::path find_protocol(const std::string& named);

/// Prints every diagnostic to stderr, errors before warnings.
void print(std::span<const Diagnostic> diagnostics);

/// Reads a protocol and prints what is wrong with it; absent if it must not be run.
[[nodiscard]] std::optional<protocols::ReadProtocol> load_protocol(const std::string& named);

}  // namespace bimodal::runner

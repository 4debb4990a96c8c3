#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "protocols/reading/read_protocol.hpp"

namespace bimodal::runner {

/// Which protocol is meant, and what is decided about it when it is run.
struct ProtocolChoice {
  std::string named;                 ///< a path, or the name of a protocol of the library
  std::vector<std::string> corpora;  ///< "NAME=FOLDER"
  std::vector<std::string> without;  ///< conditions to leave out
  std::vector<std::string> with;     ///< optional conditions to take in
};

/// PROTOCOL, --corpus, --without and --with.
void add_protocol_options(CLI::App& verb, ProtocolChoice& choice);

/// The file that the user means: a path, or the name of a protocol of the library ("words414").
[[nodiscard]] std::filesystem::path find_protocol(const std::string& named);

/// Prints every diagnostic to stderr, errors before warnings.
void print(std::span<const Diagnostic> diagnostics);

/// Reads a protocol and prints what is wrong with it; absent if it must not be run. Throws Error
/// for a --corpus without "=".
[[nodiscard]] std::optional<protocols::ReadProtocol> load_protocol(const ProtocolChoice& choice);

}  // namespace bimodal::runner

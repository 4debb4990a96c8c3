#include "runner/cli/protocol_file.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "stimuli/base/asset.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

std::filesystem::path find_protocol(const std::string& named) {
  const bool is_bare_name = named.find('/') == std::string::npos && !named.ends_with(".json");
  if (std::filesystem::exists(named) || !is_bare_name) return named;
  try {
    return asset("protocols/library/" + named + ".json");
  } catch (const Error&) {
    return named;  // the reader says that it is missing
  }
}

void print(std::span<const Diagnostic> diagnostics) {
  for (const auto severity : {Severity::Error, Severity::Warning}) {
    for (const auto& diagnostic : diagnostics) {
      if (diagnostic.severity == severity) fmt::print(stderr, "{}\n", describe(diagnostic));
    }
  }
}

std::optional<protocols::ReadProtocol> load_protocol(const std::string& named) {
  auto read = protocols::read_protocol(find_protocol(named));
  print(read.diagnostics);
  if (!has_errors(read.diagnostics)) return read;
  const auto errors = std::ranges::count(read.diagnostics, Severity::Error, &Diagnostic::severity);
  fmt::print(
      stderr, "bimodal: the protocol cannot be used: {} error{}\n", errors, errors == 1 ? "" : "s");
  return std::nullopt;
}

}  // namespace bimodal::runner

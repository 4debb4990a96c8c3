#include "stimuli/base/diagnostic.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace bimodal {

std::string describe(const Diagnostic& diagnostic) {
  std::string text = diagnostic.file;
  if (diagnostic.line > 0) text += fmt::format(":{}", diagnostic.line);
  if (!text.empty()) text += ": ";
  if (!diagnostic.pointer.empty()) text += diagnostic.pointer + ": ";
  if (diagnostic.severity == Severity::Warning) text += "warning: ";
  text += diagnostic.finding;
  if (!diagnostic.remedy.empty()) text += "; " + diagnostic.remedy;
  return text;
}

bool has_errors(std::span<const Diagnostic> diagnostics) {
  return std::ranges::any_of(diagnostics, [](const Diagnostic& diagnostic) {
    return diagnostic.severity == Severity::Error;
  });
}

}  // namespace bimodal

#include "stimuli/base/findings.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace bimodal {

namespace {

Diagnostic diagnostic(Severity severity,
                      std::string_view pointer,
                      std::string finding,
                      std::string remedy) {
  return {.severity = severity,
          .file = {},
          .line = 0,
          .pointer = std::string{pointer},
          .finding = std::move(finding),
          .remedy = std::move(remedy)};
}

}  // namespace

void Findings::error(std::string_view pointer, std::string finding, std::string remedy) {
  all_.push_back(diagnostic(Severity::Error, pointer, std::move(finding), std::move(remedy)));
}

void Findings::warning(std::string_view pointer, std::string finding, std::string remedy) {
  all_.push_back(diagnostic(Severity::Warning, pointer, std::move(finding), std::move(remedy)));
}

bool Findings::faulty(std::string_view pointer) const {
  return std::ranges::any_of(all_, [pointer](const Diagnostic& found) {
    const std::string_view other{found.pointer};
    return found.severity == Severity::Error && other.starts_with(pointer) &&
           (other.size() == pointer.size() || other[pointer.size()] == '/');
  });
}

void Findings::refuse_duplicates(const JsonLines& lines) {
  for (const auto& duplicate : lines.duplicates()) {
    error(duplicate.pointer,
          fmt::format("the same key is already on line {}", duplicate.earlier_line),
          "remove one of them");
  }
}

std::vector<Diagnostic> Findings::located(const JsonLines& lines, const std::string& file) const {
  auto diagnostics = all_;
  for (auto& diagnostic : diagnostics) {
    diagnostic.file = file;
    diagnostic.line = lines.line_of(diagnostic.pointer);
  }
  std::ranges::stable_sort(diagnostics, {}, &Diagnostic::line);
  return diagnostics;
}

}  // namespace bimodal

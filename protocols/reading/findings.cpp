#include "protocols/reading/findings.hpp"

#include <algorithm>
#include <utility>

namespace bimodal::protocols {

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

}  // namespace bimodal::protocols

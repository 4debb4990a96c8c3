#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stimuli/base/diagnostic.hpp"

namespace bimodal::protocols {

/// Collects what is wrong with one protocol, by JSON pointer; lines are looked up at the end.
class Findings {
 public:
  void error(std::string_view pointer, std::string finding, std::string remedy);
  void warning(std::string_view pointer, std::string finding, std::string remedy);

  /// Whether there is an error at this pointer or below it: its value cannot be judged further.
  [[nodiscard]] bool faulty(std::string_view pointer) const;

  [[nodiscard]] const std::vector<Diagnostic>& all() const { return all_; }

 private:
  std::vector<Diagnostic> all_;
};

}  // namespace bimodal::protocols

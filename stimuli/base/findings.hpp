#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stimuli/base/diagnostic.hpp"
#include "stimuli/base/json_lines.hpp"

namespace bimodal {

/// Collects what is wrong with one JSON file, by JSON pointer; lines are looked up at the end.
class Findings {
 public:
  void error(std::string_view pointer, std::string finding, std::string remedy);
  void warning(std::string_view pointer, std::string finding, std::string remedy);

  /// Whether there is an error at this pointer or below it: its value cannot be judged further.
  [[nodiscard]] bool faulty(std::string_view pointer) const;

  /// An error for each key that one object has more than once.
  void refuse_duplicates(const JsonLines& lines);

  [[nodiscard]] const std::vector<Diagnostic>& all() const { return all_; }

  /// All of them with file and line, in the order of the lines.
  [[nodiscard]] std::vector<Diagnostic> located(const JsonLines& lines,
                                                const std::string& file) const;

 private:
  std::vector<Diagnostic> all_;
};

}  // namespace bimodal

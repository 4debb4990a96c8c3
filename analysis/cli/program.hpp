#pragma once

#include <ostream>
#include <span>
#include <string>

namespace bimodal::analysis {

/// Where a verb writes.
struct Console {
  std::ostream& out;           ///< results
  std::ostream& err;           ///< messages and progress
  bool show_progress = false;  ///< someone is watching `err`
};

/// Exit codes, the same in every program of the project.
enum class Exit { Done = 0, Findings = 1, Usage = 2, InvalidInput = 3, Store = 5, Internal = 70 };

/// The program bimodal-analysis: reads the command line (without the program's name), does what it
/// says, reports every error on `console.err`. Never throws.
[[nodiscard]] Exit run_program(std::span<const std::string> arguments, Console console) noexcept;

}  // namespace bimodal::analysis

#pragma once

#include <ostream>
#include <span>
#include <string>

#include "stimuli/base/exit_code.hpp"

namespace bimodal::analysis {

/// Where a verb writes.
struct Console {
  std::ostream& out;           ///< results
  std::ostream& err;           ///< messages and progress
  bool show_progress = false;  ///< someone is watching `err`
};

/// The program bimodal-analysis: reads the command line (without the program's name), does what it
/// says, reports every error on `console.err`. Never throws.
[[nodiscard]] ExitCode run_program(std::span<const std::string> arguments,
                                   Console console) noexcept;

}  // namespace bimodal::analysis

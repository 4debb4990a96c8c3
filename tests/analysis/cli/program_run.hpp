#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "analysis/cli/program.hpp"

namespace bimodal::analysis {

struct ProgramRun {
  ExitCode code = ExitCode::Internal;
  std::string out;
  std::string err;
};

/// The program bimodal-analysis with this command line.
inline ProgramRun run(const std::vector<std::string>& arguments) {
  std::ostringstream out;
  std::ostringstream err;
  const auto code = run_program(arguments, {.out = out, .err = err});
  return {code, out.str(), err.str()};
}

}  // namespace bimodal::analysis

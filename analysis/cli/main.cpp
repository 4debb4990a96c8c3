#include <iostream>
#include <string>
#include <vector>

#include <unistd.h>

#include "analysis/cli/program.hpp"

int main(int argc, char** argv) {
  using bimodal::ExitCode;
  try {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    return static_cast<int>(bimodal::analysis::run_program(
        arguments,
        {.out = std::cout, .err = std::cerr, .show_progress = isatty(STDERR_FILENO) != 0}));
  } catch (...) {
    return static_cast<int>(ExitCode::Internal);
  }
}

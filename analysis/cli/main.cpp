#include <iostream>
#include <string>
#include <vector>

#include <unistd.h>

#include "analysis/cli/program.hpp"

int main(int argc, char** argv) {
  using bimodal::ExitCode;
  try {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const auto code = bimodal::analysis::run_program(
        arguments,
        {.out = std::cout, .err = std::cerr, .show_progress = isatty(STDERR_FILENO) != 0});
    if (std::cout.flush()) return static_cast<int>(code);
    std::cerr << "bimodal-analysis: standard output cannot be written (is the disk full?); what "
                 "was printed is not whole\n";
    return static_cast<int>(ExitCode::InvalidInput);
  } catch (...) {
    return static_cast<int>(ExitCode::Internal);
  }
}

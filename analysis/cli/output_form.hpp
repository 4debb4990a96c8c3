#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "analysis/cli/program.hpp"
#include "analysis/report/provenance.hpp"

namespace bimodal::analysis {

/// How figures are printed: for people, or every one of them in full precision.
struct OutputForm {
  bool json = false;
  bool csv = false;
};

/// Adds --json and --csv, of which one may be given. `form` must outlive `verb`.
void add_output_form(CLI::App& verb, OutputForm& form);

/// The same figures in each form; only the wanted one is made.
struct Renderings {
  std::function<std::string()> text;
  std::function<std::string()> csv;
  std::function<std::string()> json;
};

/// Prints the wanted form with what it is made of (text: in its last lines; JSON: under "data"; CSV
/// has no room for it: on `console.err`), and the warnings on `console.err`.
ExitCode print_as(const OutputForm& form,
                  const Renderings& renderings,
                  const Provenance& provenance,
                  const std::vector<std::string>& warnings,
                  Console console);

}  // namespace bimodal::analysis

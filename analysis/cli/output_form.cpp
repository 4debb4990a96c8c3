#include "analysis/cli/output_form.hpp"

namespace bimodal::analysis {

void add_output_form(CLI::App& verb, OutputForm& form) {
  auto* const json = verb.add_flag("--json", form.json, "Every figure, in full precision");
  verb.add_flag("--csv", form.csv, "A table in full precision, as CSV")->excludes(json);
}

ExitCode print_as(const OutputForm& form,
                  const Renderings& renderings,
                  const std::vector<std::string>& warnings,
                  Console console) {
  const auto& make = form.json ? renderings.json : form.csv ? renderings.csv : renderings.text;
  console.out << make() << std::flush;
  for (const auto& warning : warnings) console.err << "warning: " << warning << '\n';
  return ExitCode::Done;
}

}  // namespace bimodal::analysis

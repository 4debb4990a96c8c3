#include "analysis/cli/output_form.hpp"

namespace bimodal::analysis {

void add_output_form(CLI::App& verb, OutputForm& form) {
  auto* const json = verb.add_flag("--json", form.json, "Every figure, in full precision");
  verb.add_flag("--csv", form.csv, "A table in full precision, as CSV")->excludes(json);
}

ExitCode print_as(const OutputForm& form,
                  const Renderings& renderings,
                  const Provenance& provenance,
                  const std::vector<std::string>& warnings,
                  Console console) {
  if (form.json) {
    auto json = nlohmann::ordered_json::parse(renderings.json());
    json["data"] = provenance_json(provenance);
    json["warnings"] = warnings;
    console.out << json.dump(2) << '\n' << std::flush;
  } else if (form.csv) {
    console.out << renderings.csv() << std::flush;
    console.err << provenance_text(provenance);
  } else {
    console.out << renderings.text() << provenance_text(provenance) << std::flush;
  }
  for (const auto& warning : warnings) console.err << "warning: " << warning << '\n';
  return ExitCode::Done;
}

}  // namespace bimodal::analysis

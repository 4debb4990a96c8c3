#include <filesystem>

#include <fmt/format.h>

#include "runner/cli/verbs.hpp"
#include "stimuli/base/error.hpp"
#include "synth/figures/paper_figures.hpp"

namespace bimodal::runner {

namespace {

struct FiguresOptions {
  std::string folder;
  std::string format = "svg";
};

ExitCode figures(const FiguresOptions& options) {
  std::error_code fault;
  std::filesystem::create_directories(options.folder, fault);
  if (fault) {
    throw Error{fmt::format("cannot make the folder '{}': {}", options.folder, fault.message())};
  }
  for (const auto& figure : synth::paper_figures()) {
    const auto file =
        std::filesystem::path{options.folder} / fmt::format("{}.{}", figure.name, options.format);
    write_figure(synth::drawn(figure), file);
    fmt::print("{}: {}\n", file.string(), figure.title);
  }
  return ExitCode::Done;
}

}  // namespace

void add_figures(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "figures",
      "Draws figures 1 and 4 to 11 of Cohen & Massaro (1993), \"Modeling coarticulation in\n"
      "synthetic visual speech\", anew from the model: dominance above, control below. Each says\n"
      "which parameters are the paper's and which are ours.\n\n"
      "Example:\n"
      "  bimodal figures -o figures          figures/figure1.svg, figure4.svg ...");
  auto options = std::make_shared<FiguresOptions>();
  verb->add_option("-o,--output", options->folder, "folder, made if it is not there")->required();
  verb->add_option("--format", options->format, "svg (default), pdf or png")
      ->check(CLI::IsMember({"svg", "pdf", "png"}));
  verb->callback([options, &chosen] { chosen = [options] { return figures(*options); }; });
}

}  // namespace bimodal::runner

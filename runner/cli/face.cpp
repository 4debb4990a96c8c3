#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "runner/cli/control_list.hpp"
#include "runner/cli/expression_list.hpp"
#include "runner/cli/face_appearance.hpp"
#include "runner/cli/face_view.hpp"
#include "runner/cli/option_checks.hpp"
#include "runner/cli/text_table.hpp"
#include "runner/cli/verbs.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/picture/image.hpp"
#include "synth/face/head.hpp"
#include "synth/inspection/mouth_columns.hpp"
#include "synth/render/head_renderer.hpp"

namespace bimodal::runner {

namespace {

struct FaceOptions {
  std::vector<std::string> controls;
  std::vector<std::string> expressions;
  std::string output;
  ViewOptions view;
  AppearanceOptions appearance;
  std::optional<double> viewing_distance_mm;
  std::optional<double> picture_height_mm;
  bool list = false;
  bool measure = false;
};

ExitCode list_controls() {
  std::vector<std::vector<std::string>> rows{
      {"control", "in the paper", "lowest", "highest", "neutral", "unit", "meaning", "source"}};
  for (const auto& row : synth::controls()) {
    rows.push_back({std::string{row.name},
                    row.paper_name.empty() ? "-" : std::string{row.paper_name},
                    fmt::format("{:g}", row.lowest),
                    fmt::format("{:g}", row.highest),
                    fmt::format("{:g}", row.neutral),
                    std::string{row.unit},
                    std::string{row.meaning},
                    std::string{row.source}});
  }
  print_text_table(rows, "llrrrlll");
  fmt::print(
      "\nThe paper: Cohen & Massaro (1993), which tells of Pearce et al. (1986) and adds to it. "
      "Its\n"
      "names serve as well, e.g. jaw-rotation=8. Source: who described such a control first; "
      "ranges\n"
      "and units are those of this head.\n\n");
  std::vector<std::vector<std::string>> expressions{{"expression", "what it shows"}};
  for (const auto& expression : synth::expressions()) {
    expressions.push_back({std::string{expression.name}, std::string{expression.meaning}});
  }
  print_text_table(expressions, "ll");
  return ExitCode::Done;
}

void print_angles(const FaceOptions& options, const synth::View& view) {
  if (const auto angles = synth::angles_at_camera(view)) {
    fmt::print("  from the camera the picture is {:.2f} degrees high, a mm at the lips {:.4f}\n",
               angles->picture_deg,
               angles->lip_millimetre_deg);
  }
  if (options.viewing_distance_mm && options.picture_height_mm) {
    const auto angles = synth::angles_on({.viewing_distance_mm = *options.viewing_distance_mm,
                                          .picture_height_mm = *options.picture_height_mm},
                                         view);
    fmt::print("  for the participant it is {:.2f} degrees high, a mm at the lips {:.4f}\n",
               angles.picture_deg,
               angles.lip_millimetre_deg);
  }
}

void print_measures(const synth::Head& head, const synth::Pose& pose) {
  synth::MouthRuler ruler{head};
  const auto measures = ruler.measure(pose);
  std::vector<std::vector<std::string>> rows{{"measure", "value", "meaning"}};
  for (const auto& column : synth::mouth_columns()) {
    rows.push_back({std::string{column.name},
                    fmt::format("{:.2f}", column.of(measures)),
                    std::string{column.meaning}});
  }
  print_text_table(rows, "lrl");
  const auto penetrations = ruler.penetrations();
  fmt::print("parts lie in one another by at most {:.2f} mm\n", penetrations.worst());
}

ExitCode face(const FaceOptions& options) {
  if (options.list) return list_controls();
  if (options.output.empty() && !options.measure) {
    throw Error{"nothing to do; give -o FILE.png, --measure, or --list for the controls"};
  }
  const auto [pose, remarks] = possible(synth::with_expressions(
      read_controls(options.controls), read_expressions(options.expressions)));
  for (const auto& remark : remarks) fmt::print(stderr, "bimodal: {}\n", remark);
  const synth::Head head{asset("synth/assets/head")};
  if (options.measure) print_measures(head, pose);
  if (options.output.empty()) return ExitCode::Done;
  const auto view = face_view(options.view);
  const auto appearance = face_appearance(options.appearance, view);
  synth::HeadRenderer renderer{head, view, appearance};
  Image image;
  renderer.draw(pose, image);
  write_png(image, options.output);
  fmt::print("{}: {} x {} pixels\n", options.output, image.width, image.height);
  print_angles(options, view);
  return ExitCode::Done;
}

}  // namespace

void add_face(CLI::App& app, Verb& chosen) {
  auto* const verb = app.add_subcommand(
      "face",
      "Draws the face at any pose, from anywhere, whole or in part.\n\n"
      "Examples:\n"
      "  bimodal face --controls jaw=8,lip_width=-10 -o x.png\n"
      "  bimodal face --list                                      what can be set\n"
      "  bimodal face --controls jaw=3,lower_lip_tuck=1 --measure  lips, teeth and tongue in mm\n"
      "  bimodal face --controls jaw=6 --view side --transparency 0.6 -o inside.png\n"
      "  bimodal face --view side --section 0 --controls tongue_tip=9 -o section.png\n"
      "  bimodal face --expression smile=0.7 -o smile.png\n"
      "  bimodal face --show lips --material high-contrast --view mouth -o lips.png");
  auto options = std::make_shared<FaceOptions>();
  verb->add_option("--controls",
                   options->controls,
                   "NAME=VALUE,...; out of a control's range its end is taken, and told")
      ->delimiter(',');
  add_expression_option(*verb, options->expressions);
  verb->add_option("-o,--output", options->output, "PNG file to write")
      ->check(in_a_folder_that_exists());
  verb->add_flag("--measure", options->measure, "prints what of the mouth can be lipread, in mm");
  verb->add_flag("--list", options->list, "prints all controls, their ranges and meanings");
  add_view_options(*verb, options->view);
  add_appearance_options(*verb, options->appearance);
  auto* const distance = verb->add_option("--viewing-distance",
                                          options->viewing_distance_mm,
                                          "of a participant, in mm: tells the visual angles")
                             ->check(finite_number())
                             ->check(CLI::Range(10.0, 1e5));
  auto* const height = verb->add_option("--picture-height",
                                        options->picture_height_mm,
                                        "of the picture on the screen, in mm: the same")
                           ->check(finite_number())
                           ->check(CLI::Range(1.0, 1e5));
  distance->needs(height);
  height->needs(distance);
  verb->callback([options, &chosen] { chosen = [options] { return face(*options); }; });
}

}  // namespace bimodal::runner

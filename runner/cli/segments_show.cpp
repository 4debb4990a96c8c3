#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "runner/cli/option_checks.hpp"
#include "runner/cli/segments_verbs.hpp"
#include "runner/cli/text_table.hpp"
#include "stimuli/base/asset.hpp"
#include "stimuli/base/error.hpp"
#include "stimuli/figures/figure.hpp"
#include "stimuli/picture/image.hpp"
#include "stimuli/timeline/inventory_file.hpp"
#include "synth/face/head.hpp"
#include "synth/render/head_renderer.hpp"
#include "synth/speech/segment_table.hpp"

namespace bimodal::runner {

namespace {

using synth::Control;
using synth::SegmentTarget;

struct ShowOptions {
  std::string symbol;
  std::string segments = "english";
  std::string output;
  std::string picture;
};

/// Controls that move alike.
struct Dynamics {
  SegmentTarget asked;
  std::vector<std::string> controls;
};

bool is_alike(const SegmentTarget& one, const SegmentTarget& other) {
  return one.dominance == other.dominance && one.offset == other.offset;
}

std::vector<Dynamics> dynamics_of(const synth::SegmentTable& table, const Segment& segment) {
  std::vector<Dynamics> all;
  for (const auto& control : synth::controls().first<synth::kSpeechControlCount>()) {
    const auto asked = table.at(segment, control.control);
    const auto same = std::ranges::find_if(
        all, [&](const Dynamics& dynamics) { return is_alike(dynamics.asked, asked); });
    if (same == all.end()) {
      all.push_back({.asked = asked, .controls = {std::string{control.name}}});
    } else {
      same->controls.emplace_back(control.name);
    }
  }
  return all;
}

void print_values(const synth::SegmentTable& table, const Segment& segment) {
  std::vector<std::vector<std::string>> rows{{"control",
                                              "target",
                                              "unit",
                                              "alpha",
                                              "theta before",
                                              "after (1/ms)",
                                              "offset (ms)",
                                              "target from",
                                              "dynamics from"}};
  for (const auto& control : synth::controls().first<synth::kSpeechControlCount>()) {
    const auto asked = table.at(segment, control.control);
    const auto& dominance = asked.dominance;
    const bool is_virtual = asked.target < control.lowest || asked.target > control.highest;
    rows.push_back({std::string{control.name},
                    fmt::format("{:.4g}{}", asked.target, is_virtual ? " +" : "  "),
                    std::string{control.unit},
                    fmt::format("{:.3g}", dominance.alpha),
                    fmt::format("{:.4g}", dominance.theta_before),
                    fmt::format("{:.4g}", dominance.theta_after),
                    fmt::format("{:.3g}", asked.offset.count()),
                    asked.target_source,
                    asked.dynamics_source});
  }
  fmt::print("{}\n\n", symbol(segment));
  print_text_table(rows, "lrlrrrrll");
  fmt::print(
      "\n+ beyond the control's range: a virtual target, which makes a contact or an extreme "
      "last\n");
}

Figure figure_of(const synth::SegmentTable& table, const Segment& segment) {
  constexpr double kReachMs = 250;
  Figure figure{
      .title = fmt::format("{}: dominance over the controls of the face", symbol(segment)),
      .caption =
          "Time from the segment's middle. Controls named together move alike. "
          "Values at their targets are those of `bimodal segments show`.",
      .panels = {}};
  figure.columns = 2;
  figure.panel_width = 400;
  figure.panel_height = 160;
  double greatest = 1;
  for (const auto& dynamics : dynamics_of(table, segment)) {
    greatest = std::max(greatest, dynamics.asked.dominance.alpha);
  }
  for (const auto& dynamics : dynamics_of(table, segment)) {
    Panel panel{.x_label = "ms from the middle of the segment", .y_label = "dominance"};
    std::string names = fmt::format("{}", fmt::join(dynamics.controls, ", "));
    constexpr std::size_t kLongest = 90;
    if (names.size() > kLongest) names = names.substr(0, names.rfind(',', kLongest)) + " ...";
    panel.title = names;
    panel.x_range = {-kReachMs, kReachMs};
    panel.y_range = {0, 1.05 * greatest};
    Curve curve;
    for (double time = -kReachMs; time <= kReachMs; time += 1) {
      const Milliseconds from_peak = Milliseconds{time} - dynamics.asked.offset;
      curve.points.push_back({time, dynamics.asked.dominance.at(from_peak)});
    }
    panel.curves.push_back(std::move(curve));
    panel.lines.push_back({.x = 0, .label = ""});
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

/// The face with every control at the segment's target.
void write_picture(const synth::SegmentTable& table,
                   const Segment& segment,
                   const std::string& file) {
  auto pose = synth::neutral_pose();
  for (const auto& control : synth::controls().first<synth::kSpeechControlCount>()) {
    synth::value(pose, control.control) = table.at(segment, control.control).target;
  }
  const synth::Head head{asset("synth/assets/head")};
  synth::HeadRenderer renderer{head, {.width = 640, .height = 720}};
  Image image;
  renderer.draw(pose, image);
  write_png(image, file);
}

ExitCode show(const ShowOptions& options) {
  const auto parsed = parse_segment(options.symbol);
  if (const auto* fault = std::get_if<SegmentFault>(&parsed)) {
    throw Error{fmt::format("{}; {}", fault->finding, fault->remedy)};
  }
  const synth::SegmentTable table{inventory_file(options.segments)};
  const auto parts = face_segments(std::get<Segment>(parsed));
  if (parts.size() > 1 && !(options.output.empty() && options.picture.empty())) {
    throw Error{fmt::format("{} is two segments for the face; show {} or {}",
                            options.symbol,
                            symbol(parts[0]),
                            symbol(parts[1]))};
  }
  for (const auto& part : parts) print_values(table, part);
  if (!options.output.empty()) {
    write_figure(figure_of(table, parts.front()), options.output);
    fmt::print("{}: its dominance\n", options.output);
  }
  if (!options.picture.empty()) {
    write_picture(table, parts.front(), options.picture);
    fmt::print("{}: the face at its targets\n", options.picture);
  }
  return ExitCode::Done;
}

}  // namespace

void add_segments_show(CLI::App& segments, Verb& chosen) {
  auto* const verb = segments.add_subcommand(
      "show",
      "Tells every value of one segment with its source; plots its dominance, draws the face at\n"
      "its targets.\n\n"
      "Examples:\n"
      "  bimodal segments show UW\n"
      "  bimodal segments show B~W:3/8 -o half.svg --picture half.png");
  auto options = std::make_shared<ShowOptions>();
  verb->add_option("SEGMENT", options->symbol, "e.g. UW, or B~W:3/8")->required();
  verb->add_option("--segments", options->segments, "a file, or english (default)");
  verb->add_option("-o,--output", options->output, "plot of its dominance (.svg, .pdf, .png)")
      ->check(in_a_folder_that_exists());
  verb->add_option("--picture", options->picture, "the face at its targets (.png)");
  verb->callback([options, &chosen] { chosen = [options] { return show(*options); }; });
}

}  // namespace bimodal::runner

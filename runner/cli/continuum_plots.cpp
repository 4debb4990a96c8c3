#include "runner/cli/continuum_plots.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "stimuli/figures/figure.hpp"
#include "synth/speech/tracks.hpp"

namespace bimodal::runner {

namespace {

/// What the face does: controls are clamped to their ranges.
double shown_value(const synth::TokenMiddle& middle, synth::Control control) {
  const auto& range = synth::describe(control);
  return std::clamp(synth::value(middle.pose, control), range.lowest, range.highest);
}

/// Controls that the face shows differently in the middle from token to token.
std::vector<synth::Control> differing(const synth::Continuum& continuum) {
  std::vector<synth::Control> controls;
  for (const auto& row : synth::controls().first<synth::kSpeechControlCount>()) {
    const auto [lowest, highest] =
        std::ranges::minmax(continuum.middles, {}, [&](const synth::TokenMiddle& middle) {
          return shown_value(middle, row.control);
        });
    if (shown_value(highest, row.control) - shown_value(lowest, row.control) > 1e-6)
      controls.push_back(row.control);
  }
  return controls;
}

/// Controls of which the first and the last token ask something else.
std::vector<synth::Control> asked_differently(const synth::Continuum& continuum) {
  const auto& first = continuum.claims.front();
  const auto& last = continuum.claims.back();
  std::vector<synth::Control> controls;
  for (std::size_t i = 0; i < first.controls.size(); ++i) {
    const auto control = synth::control_from_name(first.controls[i]);
    if (control && first.claims[i] != last.claims[i]) controls.push_back(*control);
  }
  return controls;
}

/// From blue to red over the tokens.
FigureColour shade(double place) {
  const auto red = static_cast<FigureColour>(0x20 + place * 0xC0);
  const auto blue = static_cast<FigureColour>(0xD0 - place * 0xB0);
  return (red << 16U) | (0x50U << 8U) | blue;
}

Panel over_tokens(const synth::Continuum& continuum,
                  const std::string& label,
                  const std::function<double(const synth::TokenMiddle&)>& value) {
  Panel panel{.title = label, .x_label = "token", .y_label = label};
  Curve curve{.colour = figure_colour(2)};
  Marks marks{.colour = figure_colour(2), .is_filled = true};
  for (std::size_t i = 0; i < continuum.tokens.size(); ++i) {
    const PlotPoint point{static_cast<double>(i), value(continuum.middles[i])};
    curve.points.push_back(point);
    marks.points.push_back(point);
  }
  panel.curves.push_back(std::move(curve));
  panel.marks.push_back(std::move(marks));
  return panel;
}

Panel over_time(const synth::Continuum& continuum, synth::Control control) {
  const std::string name{synth::describe(control).name};
  Panel panel{.title = name, .x_label = "time (ms)", .y_label = synth::name_with_unit(control)};
  for (std::size_t i = 0; i < continuum.tokens.size(); ++i) {
    const auto tracks =
        synth::sample(continuum.claims[i],
                      {.rate = Hertz{500}, .account = continuum.account, .controls = {name}});
    const bool is_end = i == 0 || i + 1 == continuum.tokens.size();
    Curve curve{.colour = shade(continuum.tokens[i].place),
                .width = is_end ? 1.8 : 0.9,
                .label = is_end ? continuum.tokens[i].name : ""};
    for (std::size_t k = 0; k < tracks.time_ms.size(); ++k) {
      curve.points.push_back({tracks.time_ms[k], tracks.values.front()[k]});
    }
    panel.curves.push_back(std::move(curve));
  }
  const auto& token = continuum.tokens.front();
  for (std::size_t i = 0; i < token.score.segments.size(); ++i) {
    const auto& segment = token.score.segments[i];
    panel.stretches.push_back({.from = segment.start.count(),
                               .to = segment.end().count(),
                               .label = i == token.segment ? "_" : segment.symbol});
  }
  return panel;
}

/// Whether the first and the last token move a control differently by a hundredth of its range.
bool is_told_apart(const Panel& panel, synth::Control control) {
  const auto& range = synth::describe(control);
  const auto& first = panel.curves.front().points;
  const auto& last = panel.curves.back().points;
  for (std::size_t i = 0; i < std::min(first.size(), last.size()); ++i) {
    if (std::abs(first[i].y - last[i].y) > 0.01 * (range.highest - range.lowest)) return true;
  }
  return false;
}

}  // namespace

void write_token_plots(const synth::Continuum& continuum,
                       const std::string& title,
                       const std::string& format,
                       const std::filesystem::path& folder) {
  Figure middles{.title = title + ", in the middle of the sound",
                 .caption =
                     "As the face shows it: controls are limited to their ranges (tokens.csv "
                     "has what is asked). Those that look the same in all tokens are left "
                     "out.",
                 .panels = {}};
  middles.panels.push_back(
      over_tokens(continuum, "opening of the lips (mm)", [](const synth::TokenMiddle& middle) {
        return middle.lips.inner_height_mm;
      }));
  Figure movements{
      .title = title + ", over time",
      .caption =
          "From the first token (blue) to the last (red). Controls that go alike are left out.",
      .panels = {}};
  for (const auto control : differing(continuum)) {
    middles.panels.push_back(over_tokens(
        continuum, synth::name_with_unit(control), [=](const synth::TokenMiddle& middle) {
          return shown_value(middle, control);
        }));
  }
  const auto asked = asked_differently(continuum);
  constexpr std::size_t kFew = 4;  // what is varied is always drawn
  for (const auto control : asked) {
    auto panel = over_time(continuum, control);
    if (asked.size() > kFew && !is_told_apart(panel, control)) continue;
    movements.panels.push_back(std::move(panel));
  }
  middles.columns = 3;
  middles.panel_width = 270;
  middles.panel_height = 160;
  write_figure(middles, folder / ("controls." + format));
  movements.columns = 2;
  movements.panel_width = 400;
  movements.panel_height = 170;
  write_figure(movements, folder / ("movements." + format));
}

}  // namespace bimodal::runner

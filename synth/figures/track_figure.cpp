#include "synth/figures/track_figure.hpp"

#include <algorithm>

#include "synth/speech/control.hpp"

namespace bimodal::synth {

namespace {

std::string axis_label(const std::string& name) {
  const auto control = control_from_name(name);
  return control ? name_with_unit(*control) : name;
}

Panel frame(const Tracks& tracks) {
  Panel panel;
  const double end = tracks.segments.empty() ? 1 : tracks.segments.back().end.count();
  panel.x_range = {0, end};
  for (std::size_t i = 0; i < tracks.segments.size(); ++i) {
    panel.stretches.push_back({.from = tracks.segments[i].start.count(),
                               .to = tracks.segments[i].end.count(),
                               .label = tracks.symbols[i]});
  }
  return panel;
}

Panel dominance_panel(const Tracks& tracks, std::size_t control) {
  Panel panel = frame(tracks);
  panel.title = tracks.controls[control];
  panel.y_label = "dominance";
  for (std::size_t row = 0; row < tracks.dominance[control].size(); ++row) {
    Curve curve{.colour = figure_colour(row)};
    for (std::size_t i = 0; i < tracks.time_ms.size(); ++i) {
      curve.points.push_back({tracks.time_ms[i], tracks.dominance[control][row][i]});
    }
    panel.curves.push_back(std::move(curve));
  }
  return panel;
}

Panel control_panel(const Tracks& tracks, std::size_t control) {
  Panel panel = frame(tracks);
  panel.title = tracks.dominance.empty() ? tracks.controls[control] : "";
  panel.y_label = axis_label(tracks.controls[control]);
  panel.x_label = "time (ms)";
  Curve curve;
  for (std::size_t i = 0; i < tracks.time_ms.size(); ++i) {
    curve.points.push_back({tracks.time_ms[i], tracks.values[control][i]});
  }
  panel.curves.push_back(std::move(curve));
  Marks targets{.colour = figure_colour(1)};
  for (const auto& claim : tracks.claims[control]) {
    targets.points.push_back({claim.peak.count(), claim.target});
  }
  std::erase_if(targets.points, [&](const PlotPoint& point) {
    return point.x < panel.x_range->first || point.x > panel.x_range->second;
  });
  panel.marks.push_back(std::move(targets));
  return panel;
}

bool moves(const std::vector<double>& values) {
  const auto [lowest, highest] = std::ranges::minmax(values);
  return highest - lowest > 1e-9;
}

}  // namespace

Figure figure_of(const Tracks& tracks, const std::string& title) {
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < tracks.controls.size(); ++i) {
    if (!tracks.values[i].empty() && moves(tracks.values[i])) shown.push_back(i);
  }
  if (shown.empty()) {
    for (std::size_t i = 0; i < tracks.controls.size(); ++i) shown.push_back(i);
  }
  Figure figure{.title = title, .panels = {}};
  constexpr std::size_t kManySegments = 40;
  figure.columns = shown.size() > 1 && tracks.segments.size() < kManySegments ? 2 : 1;
  // Wide enough for the names of the segments.
  constexpr double kSegmentWidth = 20;
  constexpr double kWidest = 2000;
  figure.panel_width =
      std::clamp(kSegmentWidth * static_cast<double>(tracks.segments.size()) + 60, 420.0, kWidest);
  figure.panel_height = 170;
  for (std::size_t first = 0; first < shown.size(); first += figure.columns) {
    const auto last = std::min(first + figure.columns, shown.size());
    if (!tracks.dominance.empty()) {
      for (auto i = first; i < last; ++i) {
        figure.panels.push_back(dominance_panel(tracks, shown[i]));
      }
      if (last - first < figure.columns) figure.panels.emplace_back();
    }
    for (auto i = first; i < last; ++i) figure.panels.push_back(control_panel(tracks, shown[i]));
  }
  return figure;
}

}  // namespace bimodal::synth

#include <algorithm>
#include <span>
#include <vector>

#include "synth/figures/paper_figures.hpp"

namespace bimodal::synth {

namespace {

constexpr double kStepMs = 0.5;

constexpr FigureColour kShared = 0x808080;  ///< of what is the same in all traces

/// What the traces of a panel have in common: whether each claim of the first is that of all.
std::vector<bool> shared_claims(const PaperPanel& panel) {
  const auto first = claims_of(panel.traces.front().score).claims.front();
  std::vector<bool> shared(first.size(), panel.traces.size() > 1);
  for (const auto& trace : panel.traces) {
    const auto claims = claims_of(trace.score).claims.front();
    for (std::size_t i = 0; i < shared.size(); ++i) {
      shared[i] = shared[i] && i < claims.size() && claims[i] == first[i];
    }
  }
  return shared;
}

/// The panel that both rows of one figure begin with.
Panel frame(const PaperPanel& panel, const ScoreClaims& first, double end_ms) {
  Panel made{.x_range = std::pair{0.0, end_ms}, .lines = panel.lines};
  if (panel.traces.size() > 1 &&
      panel.traces.back().score.end() != panel.traces.front().score.end()) {
    return made;  // rates: segments stand elsewhere in each
  }
  for (std::size_t i = 0; i < first.claimants.size(); ++i) {
    made.stretches.push_back({.from = first.claimants[i].start.count(),
                              .to = first.claimants[i].end.count(),
                              .label = first.symbols[i]});
  }
  return made;
}

/// What one trace adds to the panel of dominances and to that of the control. What `shared` says is
/// the same in all traces is drawn once, with the first.
void add_trace(const PaperPanel& panel,
               std::size_t index,
               const std::vector<bool>& shared,
               Panel& dominance,
               Panel& control) {
  const auto& trace = panel.traces[index];
  const auto claims = claims_of(trace.score);
  const auto movement = claims.movement(trace.account);
  const double end = trace.score.end().count();
  Curve moved{.colour = figure_colour(index), .label = trace.label};
  for (double time = 0; time <= end; time += kStepMs) {
    double value = 0;
    movement->at(Milliseconds{time}, std::span{&value, 1});
    moved.points.push_back({time, value});
  }
  Marks targets{.colour = figure_colour(index)};
  Marks shared_targets{.colour = kShared};
  for (std::size_t k = 0; k < claims.claims.front().size(); ++k) {
    const auto& claim = claims.claims.front()[k];
    const bool is_shared = k < shared.size() && shared[k];
    if (is_shared && index > 0) continue;
    auto& marks = is_shared ? shared_targets : targets;
    marks.points.push_back({claim.peak.count(), claim.target});
    Curve dominated{.colour = is_shared ? kShared : figure_colour(index)};
    for (double time = 0; time <= end; time += kStepMs) {
      dominated.points.push_back({time, claim.dominance.at(Milliseconds{time} - claim.peak)});
    }
    dominance.curves.push_back(std::move(dominated));
  }
  control.curves.push_back(std::move(moved));
  control.marks.push_back(std::move(targets));
  control.marks.push_back(std::move(shared_targets));
}

}  // namespace

double value_at(const Trace& trace, Milliseconds time) {
  double value = 0;
  claims_of(trace.score).movement(trace.account)->at(time, std::span{&value, 1});
  return value;
}

Figure drawn(const PaperFigure& figure) {
  Figure made{.title = figure.title, .caption = figure.caption, .panels = {}};
  const bool has_dominance = figure.panels.front().shows_dominance;
  made.columns = figure.columns;
  made.panel_width = figure.columns == 1 ? 460 : figure.columns == 2 ? 420 : 330;
  std::vector<Panel> above;
  std::vector<Panel> below;
  for (const auto& panel : figure.panels) {
    double end_ms = 0;
    for (const auto& trace : panel.traces) end_ms = std::max(end_ms, trace.score.end().count());
    const auto first = claims_of(panel.traces.front().score);
    auto dominance = frame(panel, first, end_ms);
    auto control = frame(panel, first, end_ms);
    dominance.title = panel.title;
    dominance.y_label = "dominance";
    dominance.y_range = {0, 1.05};
    control.title = has_dominance ? "" : panel.title;
    control.y_label = panel.y_label;
    control.x_label = "time (ms)";
    const auto shared = shared_claims(panel);
    for (std::size_t i = 0; i < panel.traces.size(); ++i) {
      add_trace(panel, i, shared, dominance, control);
    }
    control.y_range = {0, 1};
    above.push_back(std::move(dominance));
    below.push_back(std::move(control));
  }
  if (has_dominance) made.panels = above;
  made.panels.insert(made.panels.end(), below.begin(), below.end());
  return made;
}

}  // namespace bimodal::synth

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "runner/cli/timing_report.hpp"
#include "stimuli/base/markup.hpp"
#include "stimuli/base/milliseconds.hpp"
#include "stimuli/figures/figure.hpp"

namespace bimodal::runner {

namespace {

constexpr const char* kStyle =
    "body{font:16px/1.5 system-ui,sans-serif;max-width:56rem;margin:2rem auto;padding:0 1rem;"
    "color:#222}h1{font-size:1.5rem}table{border-collapse:collapse;margin:1rem 0}"
    "td,th{padding:.25rem .75rem;border-bottom:1px solid #ccc;text-align:right}"
    "td:first-child,th:first-child{text-align:left}svg{max-width:100%;height:auto}"
    ".good{color:#060}.usable{color:#850}.not_for_timing{color:#a00}"
    "pre{white-space:pre-wrap}";

Panel histogram_panel(const TimingSummary& summary) {
  const auto histogram = histogram_of(summary.offsets, 40);
  Curve outline{.colour = figure_colour(5), .width = 1.6};
  if (!histogram.bins.empty()) outline.points.push_back({histogram.bins.front().from_ms, 0});
  for (const auto& bin : histogram.bins) {
    const auto count = static_cast<double>(bin.count);
    outline.points.push_back({bin.from_ms, count});
    outline.points.push_back({bin.from_ms + histogram.width_ms, count});
  }
  if (!histogram.bins.empty()) {
    outline.points.push_back({histogram.bins.back().from_ms + histogram.width_ms, 0});
  }
  Panel panel{.title = "How often",
              .x_label = "audio-visual offset off the intended one (ms)",
              .y_label = "trials",
              .curves = {std::move(outline)}};
  if (!histogram.bins.empty()) {
    panel.x_range = {histogram.bins.front().from_ms - histogram.width_ms,
                     histogram.bins.back().from_ms + 2 * histogram.width_ms};
  }
  return panel;
}

/// Leaves room above the marks for the legend.
std::optional<std::pair<double, double>> range_of(const std::vector<Marks>& marks) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const auto& each : marks) {
    for (const auto& point : each.points) {
      low = std::min(low, point.y);
      high = std::max(high, point.y);
    }
  }
  const double extent = high - low;
  if (!(extent > 0.0)) return std::nullopt;
  return std::pair{low - 0.05 * extent, high + 0.4 * extent};
}

Panel course_panel(const TimingFindings& findings) {
  Marks kept{.colour = figure_colour(5), .is_filled = true, .label = "trials"};
  Marks flagged{.colour = figure_colour(6), .label = "flagged"};
  for (const auto& trial : findings.trials) {
    const bool measured = trial.true_visual && trial.true_auditory;
    if (!measured && (!findings.input.empty() || !trial.visual || !trial.auditory)) continue;
    const auto offset =
        measured ? *trial.true_auditory - *trial.true_visual : *trial.auditory - *trial.visual;
    (trial.record.flagged ? flagged : kept)
        .points.push_back({static_cast<double>(trial.record.trial + 1),
                           milliseconds(offset - findings.intended)});
  }
  Panel panel{.title = "Trial by trial", .x_label = "trial", .y_label = "offset off (ms)"};
  if (!kept.points.empty()) panel.marks.push_back(std::move(kept));
  if (!flagged.points.empty()) panel.marks.push_back(std::move(flagged));
  panel.y_range = range_of(panel.marks);
  return panel;
}

std::string row(std::string_view what, const Moments& moments) {
  if (moments.count == 0) return {};
  return fmt::format(
      "<tr><td>{}</td><td>{}</td><td>{:+.3f}</td><td>{:.3f}</td><td>{:+.3f}</td><td>{:+.3f}</td></"
      "tr>\n",
      what,
      moments.count,
      moments.mean_ms,
      moments.deviation_ms,
      moments.smallest_ms,
      moments.largest_ms);
}

}  // namespace

std::string as_page(const TimingFindings& findings) {
  const auto summary = summarise(findings);
  auto page = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>Timing, {0}</title>"
      "<style>{1}</style>\n<h1>Timing of flashes and beeps</h1>\n<p>{0}</p>\n",
      escaped(findings.made_utc),
      kStyle);
  page += fmt::format("<p>Verdict on the screen: <b class=\"{0}\">{0}</b>{1}</p>\n",
                      name(findings.gate.verdict),
                      findings.gate.reasons.empty()
                          ? std::string{}
                          : escaped(fmt::format(" - {}", fmt::join(findings.gate.reasons, "; "))));
  page += fmt::format(
      "<p>{} trials after the first, {} flagged. Audio-visual offset is audio minus visual; {:+g} "
      "ms "
      "intended.</p>\n<table><tr><th>ms</th><th>trials</th><th>mean</th><th>SD</th><th>smallest</"
      "th>"
      "<th>largest</th></tr>\n",
      summary.trials,
      summary.flagged,
      milliseconds(findings.intended));
  page += row("offset as reported, off the intended one", summary.reported);
  page += row("offset as measured, off the intended one", summary.measured);
  page += row("light, measured minus reported", summary.visual);
  page += row("sound, measured minus reported", summary.auditory);
  page += "</table>\n";
  if (!summary.offsets.empty()) {
    page += svg_of({.title = "Audio-visual offset",
                    .caption = findings.input.empty() ? "By the computer's own word."
                                                      : "By the photodiode and the cable.",
                    .panels = {histogram_panel(summary), course_panel(findings)}});
  }
  page +=
      "<h2>As a terminal shows it</h2>\n<pre>" + escaped(as_text(findings)) + "</pre>\n</html>\n";
  return page;
}

}  // namespace bimodal::runner

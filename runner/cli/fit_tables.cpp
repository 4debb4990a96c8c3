#include "runner/cli/fit_tables.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "runner/cli/text_table.hpp"
#include "stimuli/base/counted.hpp"

namespace bimodal::runner {

namespace {

std::string shown_r(const std::optional<double>& r) {
  return r ? fmt::format("{:.2f}", *r) : "-";
}

void print_parts(const FitReport& report) {
  std::vector<std::vector<std::string>> rows{
      {"part", "class", "tokens", "target", "alpha", "theta before", "after", "offset ms"}};
  for (std::size_t part = 0; part < synth::parts().size(); ++part) {
    if (report.fit.tokens[part] == 0) continue;
    const auto& asked = report.fit.dynamics[part];
    rows.push_back({std::string{synth::parts()[part].name},
                    std::string{synth::parts()[part].class_name},
                    fmt::to_string(report.fit.tokens[part]),
                    fmt::format("{:.2f}", asked.target),
                    fmt::format("{:.2f}", std::exp(asked.log_alpha)),
                    fmt::format("{:.4f}", std::exp(asked.log_theta_before)),
                    fmt::format("{:.4f}", std::exp(asked.log_theta_after)),
                    fmt::format("{:.1f}", asked.offset_ms)});
  }
  print_text_table(rows, "llrrrrrr");
}

void print_clips(const FitReport& report) {
  const bool opens = report.options.kind == synth::MeasureKind::Opening;
  const bool has_left_out = !report.left_out.empty();
  std::vector<std::vector<std::string>> rows{
      {"clip", "instants", opens ? "gain" : "offset", "RMSE", "r"}};
  if (has_left_out) rows[0].insert(rows[0].end(), {"left-out RMSE", "scaled", "r"});
  for (std::size_t i = 0; i < report.clips.size(); ++i) {
    const double talker = report.fit.talkers[i];
    auto& row =
        rows.emplace_back(std::vector{report.clips[i].name,
                                      fmt::to_string(report.fitted[i].instants),
                                      fmt::format("{:.2f}", opens ? std::exp(talker) : talker),
                                      fmt::format("{:.2f}", report.fitted[i].rmse()),
                                      shown_r(report.fitted[i].r)});
    if (!has_left_out) continue;
    row.push_back(fmt::format("{:.2f}", report.left_out[i].rmse()));
    row.push_back(fmt::format("{:.2f}", report.left_out[i].rmse_scaled()));
    row.push_back(shown_r(report.left_out[i].r));
  }
  print_text_table(rows, has_left_out ? "lrrrrrrr" : "lrrrr");
}

}  // namespace

std::vector<std::string> column_names(const LabelledTrack& recording) {
  std::vector<std::string> names;
  for (const auto& column : recording.track.columns) names.push_back(column.name);
  return names;
}

FitReport report_of(const std::string& column,
                    std::vector<synth::MeasuredClip> clips,
                    synth::Chosen chosen,
                    synth::Fit fit) {
  FitReport report{
      .column = column,
      .relative = chosen.options.kind == synth::MeasureKind::Position && chosen.options.own_talkers,
      .clips = std::move(clips),
      .options = chosen.options,
      .fit = std::move(fit),
      .left_out = std::move(chosen.left_out)};
  for (std::size_t i = 0; i < report.clips.size(); ++i) {
    const auto told = predicted(report.fit, report.clips[i], report.fit.talkers[i]);
    report.fitted.push_back(synth::agreement(told, report.clips[i].values));
  }
  return report;
}

std::string summary(const FitReport& report) {
  const auto fitted = synth::over_clips(report.fitted);
  auto text = fmt::format("{}, {}; shrinkage {:g}; fitted RMSE {:.2f}, r {}",
                          counted(report.clips.size(), "clip"),
                          counted(fitted.instants, "instant"),
                          report.options.shrinkage,
                          fitted.rmse(),
                          shown_r(fitted.r));
  if (report.left_out.empty()) return text;
  const auto left_out = synth::over_clips(report.left_out);
  return text + fmt::format("; left-out RMSE {:.2f}, scaled {:.2f}, r {}",
                            left_out.rmse(),
                            left_out.rmse_scaled(),
                            shown_r(left_out.r));
}

void print_fit(const FitReport& report) {
  fmt::print("{}: {}\n", report.column, summary(report));
  if (report.relative) fmt::print("targets are relative to the talker's mean over the speech\n");
  print_parts(report);
  fmt::print("\n");
  print_clips(report);
  fmt::print("\n");
}

}  // namespace bimodal::runner

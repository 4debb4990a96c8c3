#include "runner/cli/lip_tables.hpp"

#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "runner/cli/lip_summary.hpp"
#include "runner/cli/text_table.hpp"
#include "stimuli/base/csv.hpp"

namespace bimodal::runner {

namespace {

using synth::Middle;

/// A number of a comparison, and what it is.
struct Line {
  std::string clip;
  std::string phone;
  std::string measure;
  std::string quantity;
  std::size_t count;
  double value;
};

std::vector<std::string> agreement_row(const std::string& measure,
                                       const std::string& clip,
                                       const synth::Agreement& found) {
  return {measure,
          clip,
          fmt::to_string(found.instants),
          found.r ? fmt::format("{:.2f}", *found.r) : "-",
          fmt::format("{:.2f}", found.rmse()),
          fmt::format("{:.2f}", found.rmse_scaled()),
          fmt::format("{:.2f}", found.gain)};
}

void print_agreement(std::span<const ClipComparison> clips) {
  std::vector<std::vector<std::string>> rows{
      {"measure", "clip", "instants", "r", "RMSE", "scaled", "gain"}};
  for (const auto& measure : measures_of(clips)) {
    for (const auto& clip : clips) {
      if (const auto* const one = comparison_of(clip, measure)) {
        rows.push_back(agreement_row(measure, clip.clip, one->agreement));
      }
    }
    rows.push_back(agreement_row(measure, "all", over_clips(clips, measure)));
  }
  print_text_table(rows, "llrrrrr");
}

std::string shown(const Middle& middle) {
  if (middle.count == 0) return "-";
  if (!middle.sd) return fmt::format("{:.0f} (n 1)", middle.median);
  return fmt::format("{:.0f} (SD {:.0f}, n {})", middle.median, *middle.sd, middle.count);
}

void print_timing(std::span<const ClipComparison> clips) {
  const auto lips = closed_of(clips);
  fmt::print("lips that shut (below {:g} mm): measured {} of {}, predicted {} of {}\n",
             synth::kShutMm,
             lips.measured,
             lips.tokens,
             lips.predicted,
             lips.tokens);
  std::vector<std::vector<std::string>> rows{
      {"phones", "median time in ms", "measured", "predicted", "predicted - measured"}};
  for (const auto& found : moments_of(clips)) {
    rows.push_back({std::string{found.phones},
                    std::string{found.moment},
                    shown(found.measured),
                    shown(found.predicted),
                    shown(found.difference)});
  }
  print_text_table(rows, "lllll");
}

void print_phones(std::span<const ClipComparison> clips) {
  const auto heights = phone_means(clips, "inner_h");
  const auto widths = phone_means(clips, "outer_w");
  const auto& all = heights.empty() ? widths : heights;
  if (all.empty()) return;
  std::vector<std::vector<std::string>> rows{
      {"phone", "n", "inner_h measured", "predicted", "outer_w measured", "predicted"}};
  for (const auto& [phone, mean] : all) {
    auto& row =
        rows.emplace_back(std::vector{std::string{symbol(phone)}, fmt::to_string(mean.count)});
    for (const auto* const means : {&heights, &widths}) {
      const auto found = means->find(phone);
      row.push_back(found == means->end() ? "-" : fmt::format("{:.1f}", found->second.measured));
      row.push_back(found == means->end() ? "-" : fmt::format("{:.1f}", found->second.predicted));
    }
  }
  print_text_table(rows, "lrrrrr");
}

void add_agreement(std::vector<Line>& lines,
                   const std::string& clip,
                   const std::string& measure,
                   const synth::Agreement& found) {
  const auto add = [&](const char* quantity, double value) {
    lines.push_back({clip, "", measure, quantity, found.instants, value});
  };
  if (found.r) add("r", *found.r);
  add("rmse", found.rmse());
  add("rmse_scaled", found.rmse_scaled());
  add("offset", found.offset);
  add("gain", found.gain);
}

void add_moment(std::vector<Line>& lines, const MomentSummary& found) {
  const auto add = [&](const char* whose, const Middle& middle) {
    if (middle.count == 0) return;
    const auto add_line = [&](const char* statistic, double value) {
      lines.push_back({"all",
                       std::string{found.phones},
                       std::string{found.measure},
                       fmt::format("{}: {} {}, ms", found.moment, whose, statistic),
                       middle.count,
                       value});
    };
    add_line("median", middle.median);
    if (middle.sd) add_line("sd", *middle.sd);
  };
  add("measured", found.measured);
  add("predicted", found.predicted);
  add("difference", found.difference);
}

std::vector<Line> lines_of(std::span<const ClipComparison> clips) {
  std::vector<Line> lines;
  for (const auto& measure : measures_of(clips)) {
    for (const auto& clip : clips) {
      if (const auto* const one = comparison_of(clip, measure)) {
        add_agreement(lines, clip.clip, measure, one->agreement);
      }
    }
    add_agreement(lines, "all", measure, over_clips(clips, measure));
    for (const auto& [phone, mean] : phone_means(clips, measure)) {
      const std::string name{symbol(phone)};
      lines.push_back({"all", name, measure, "mean_measured", mean.count, mean.measured});
      lines.push_back({"all", name, measure, "mean_predicted", mean.count, mean.predicted});
    }
  }
  for (const auto& found : moments_of(clips)) add_moment(lines, found);
  return lines;
}

}  // namespace

void print_comparison(std::span<const ClipComparison> clips) {
  print_agreement(clips);
  fmt::print("\n");
  print_timing(clips);
  fmt::print("\nat the centres of phones; outer_w relative to the talker's mean\n");
  print_phones(clips);
}

std::string comparison_csv(std::span<const ClipComparison> clips) {
  std::string text = "clip,phone,measure,quantity,n,value\n";
  for (const auto& line : lines_of(clips)) {
    fmt::format_to(std::back_inserter(text),
                   "{},{},{},{},{},{:.4f}\n",
                   csv_field(line.clip),
                   line.phone,
                   csv_field(line.measure),
                   csv_field(line.quantity),
                   line.count,
                   line.value);
  }
  return text;
}

}  // namespace bimodal::runner

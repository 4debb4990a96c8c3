#include "analysis/report/information_table.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/report/csv.hpp"
#include "analysis/report/json_count.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kWhole = "(all)";

std::optional<TransmissionInterval> interval_of_transmission(const ConfusionMatrix& matrix,
                                                             const IntervalRequest& intervals) {
  if (!intervals.seed) return std::nullopt;
  return transmission_interval(matrix, *intervals.seed, intervals.draws);
}

FeatureInformation information_of(const ConfusionMatrix& matrix,
                                  const FeatureTable& features,
                                  std::size_t feature,
                                  const IntervalRequest& intervals) {
  const auto groups = grouped(matrix,
                              features.values_of(matrix.stimuli(), feature),
                              features.values_of(matrix.responses(), feature));
  return {.feature = features.features[feature],
          .left_out = matrix.total() - groups.total(),
          .information = information(groups),
          .jackknifed = jackknifed_transmission(groups),
          .interval = interval_of_transmission(groups, intervals)};
}

std::string text_row(std::string_view name,
                     std::size_t width,
                     const Information& found,
                     const std::optional<JackknifedTransmission>& jackknifed,
                     const std::optional<TransmissionInterval>& interval,
                     double left_out) {
  return fmt::format(
      "  {:<{}}{:>8}{:>9.3f}{:>9.3f}{:>9.3f}{:>8}{:>9.3f}{:>9.3f}{:>9}  {}{}\n",
      name,
      width,
      found.responses,
      found.stimulus_entropy,
      found.response_entropy,
      found.transmitted,
      found.relative ? fmt::format("{:.3f}", *found.relative) : "-",
      found.miller_madow,
      found.all_cells_possible,
      jackknifed ? fmt::format("{:.3f}", jackknifed->estimate) : "-",
      interval && interval->interval
          ? fmt::format("[{:.3f}, {:.3f}]", interval->interval->low, interval->interval->high)
          : "none",
      left_out == 0 ? "" : fmt::format("   {} left out", left_out));
}

Json as_json(const Information& found) {
  return {{"n", json_count(found.responses)},
          {"stimulus_entropy_bits", found.stimulus_entropy},
          {"response_entropy_bits", found.response_entropy},
          {"joint_entropy_bits", found.joint_entropy},
          {"transmitted_bits", found.transmitted},
          {"transmitted_relative", optional_json(found.relative)},
          {"transmitted_miller_madow_bits", found.miller_madow},
          {"transmitted_all_cells_possible_bits", found.all_cells_possible}};
}

Json as_json(const std::optional<JackknifedTransmission>& jackknifed) {
  return jackknifed ? Json(jackknifed->estimate) : Json();
}

Json as_json(const std::optional<TransmissionInterval>& interval) {
  if (!interval) return {};
  return {{"interval", interval_json(interval->interval)},
          {"level", 0.95},
          {"measured_coverage", interval->measured_coverage},
          {"simulated_studies", interval->simulated},
          {"why_none", interval->why_none}};
}

/// What the columns mean, and why there is or is no interval.
std::string notes(const InformationTable& table) {
  auto text = fmt::format(
      "\nT: transmitted, as observed: of few responses too large. It is corrected in three\n"
      "ways, to be read together: by Miller & Madow for the cells that occurred (MM: takes\n"
      "off too little, and of very few responses adds), by (r-1)(c-1)/(2n ln 2) as if every\n"
      "cell were possible (rc: takes off too much where most are not, and a little too\n"
      "little where all are), and by the jackknife.\n"
      "Stimuli: {}, with {:.1f} responses each on average.\n",
      table.stimuli,
      table.whole.responses / static_cast<double>(table.stimuli));
  if (!table.interval) {
    const auto& why = table.why_no_intervals;
    return text +
           fmt::format("There is no interval: {}.\n", why.empty() ? "none was asked for" : why);
  }
  if (!table.interval->interval) {
    return text + fmt::format("There is no interval: {}.\n", table.interval->why_none);
  }
  return text +
         fmt::format(
             "Interval: studentised bootstrap of the jackknife estimate, for responses that "
             "are\nindependent of each other; of {} simulated studies at these counts {:.0f} "
             "% were covered.\n",
             table.interval->simulated,
             100.0 * table.interval->measured_coverage);
}

void append_line(std::string& table,
                 std::string_view name,
                 const std::optional<Information>& found,
                 const std::optional<JackknifedTransmission>& jackknifed,
                 const std::optional<TransmissionInterval>& interval,
                 double left_out) {
  std::vector<CsvField> line{name, left_out};
  if (found) {
    line.insert(line.end(),
                {found->responses,
                 found->stimulus_entropy,
                 found->response_entropy,
                 found->joint_entropy,
                 found->transmitted,
                 csv_number(found->relative),
                 found->miller_madow,
                 found->all_cells_possible});
  } else {
    line.insert(line.end(), {0.0, {}, {}, {}, {}, {}, {}, {}});
  }
  const bool has_interval = interval && interval->interval;
  line.push_back(jackknifed ? CsvField{jackknifed->estimate} : CsvField{});
  line.push_back(has_interval ? CsvField{interval->interval->low} : CsvField{});
  line.push_back(has_interval ? CsvField{interval->interval->high} : CsvField{});
  line.push_back(interval ? CsvField{interval->measured_coverage} : CsvField{});
  append_csv(table, line);
}

}  // namespace

InformationTable tabulate_information(std::string title,
                                      const ConfusionMatrix& matrix,
                                      const FeatureTable& features,
                                      const IntervalRequest& intervals) {
  const auto whole = information(matrix);
  if (!whole) throw Error{fmt::format("{}: the matrix has no responses", title)};
  InformationTable table{.title = std::move(title),
                         .whole = *whole,
                         .jackknifed = jackknifed_transmission(matrix),
                         .interval = interval_of_transmission(matrix, intervals),
                         .why_no_intervals = intervals.why_none,
                         .features = {}};
  for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
    if (matrix.row_total(i) > 0) ++table.stimuli;
  }
  if (!features.features.empty()) require_stimuli(matrix, features);
  for (std::size_t feature = 0; feature < features.features.size(); ++feature) {
    table.features.push_back(information_of(matrix, features, feature, intervals));
  }
  return table;
}

std::string information_text(const InformationTable& table) {
  std::size_t width = kWhole.size();
  for (const auto& feature : table.features) width = std::max(width, feature.feature.size());
  auto text = fmt::format(
      "{}: information in bits\n\n  {:<{}}{:>8}{:>9}{:>9}{:>9}{:>8}{:>9}{:>9}{:>9}  {}\n",
      table.title,
      "",
      width,
      "n",
      "H(x)",
      "H(y)",
      "T",
      "T/H(x)",
      "T (MM)",
      "T (rc)",
      "T (jack)",
      "95 % interval");
  text += text_row(kWhole, width, table.whole, table.jackknifed, table.interval, 0);
  for (const auto& feature : table.features) {
    if (feature.information) {
      text += text_row(feature.feature,
                       width,
                       *feature.information,
                       feature.jackknifed,
                       feature.interval,
                       feature.left_out);
    } else {
      text += fmt::format(
          "  {:<{}}{:>8}   all {} left out\n", feature.feature, width, 0, feature.left_out);
    }
  }
  return text + notes(table);
}

std::string information_csv(const InformationTable& table) {
  std::string text;
  const std::vector<CsvField> header{std::string_view{"feature"},
                                     std::string_view{"left_out"},
                                     std::string_view{"n"},
                                     std::string_view{"stimulus_entropy_bits"},
                                     std::string_view{"response_entropy_bits"},
                                     std::string_view{"joint_entropy_bits"},
                                     std::string_view{"transmitted_bits"},
                                     std::string_view{"transmitted_relative"},
                                     std::string_view{"transmitted_miller_madow_bits"},
                                     std::string_view{"transmitted_all_cells_possible_bits"},
                                     std::string_view{"transmitted_jackknife_bits"},
                                     std::string_view{"low"},
                                     std::string_view{"high"},
                                     std::string_view{"measured_coverage"}};
  append_csv(text, header);
  append_line(text, kWhole, table.whole, table.jackknifed, table.interval, 0);
  for (const auto& feature : table.features) {
    append_line(text,
                feature.feature,
                feature.information,
                feature.jackknifed,
                feature.interval,
                feature.left_out);
  }
  return text;
}

std::string information_json(const InformationTable& table) {
  Json json{{"title", table.title}, {"stimuli", table.stimuli}};
  json.update(as_json(table.whole));
  json["transmitted_jackknife_bits"] = as_json(table.jackknifed);
  json["transmitted_interval"] = as_json(table.interval);
  if (!table.interval) json["why_no_interval"] = table.why_no_intervals;
  json["features"] = Json::array();
  for (const auto& feature : table.features) {
    Json row{{"feature", feature.feature}, {"left_out", json_count(feature.left_out)}};
    if (feature.information) {
      row.update(as_json(*feature.information));
      row["transmitted_jackknife_bits"] = as_json(feature.jackknifed);
      row["transmitted_interval"] = as_json(feature.interval);
    } else {
      row["n"] = 0;
    }
    json["features"].push_back(std::move(row));
  }
  return json.dump(2) + "\n";
}

}  // namespace bimodal::analysis

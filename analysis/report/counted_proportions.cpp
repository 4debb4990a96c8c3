#include "analysis/report/counted_proportions.hpp"

#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "analysis/report/csv.hpp"
#include "analysis/report/json_count.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::ordered_json;

std::optional<double> proportion(const CountedSuccesses& counted) {
  if (counted.trials == 0) return std::nullopt;
  return static_cast<double>(counted.successes) / static_cast<double>(counted.trials);
}

Json labels_of(const std::vector<std::string>& names, const std::vector<std::string>& labels) {
  Json json = Json::object();
  for (std::size_t i = 0; i < names.size(); ++i) json[names[i]] = labels[i];
  return json;
}

}  // namespace

CountedProportions estimate_counts(CountsTable counts,
                                   double level,
                                   std::optional<int> alternatives) {
  CountedProportions table{
      .counts = std::move(counts), .level = level, .alternatives = alternatives};
  for (const auto& counted : table.counts.rows) {
    auto& intervals = table.intervals.emplace_back();
    for (const auto method : kIntervalMethods) {
      intervals.push_back(interval_of(method, counted.successes, counted.trials, level));
    }
    table.sensitivities.push_back(
        alternatives ? sensitivity_of_choices(counted.successes, counted.trials, *alternatives)
                     : std::nullopt);
  }
  return table;
}

std::string counted_proportions_text(const CountedProportions& table) {
  auto text =
      fmt::format("{:g} % intervals of proportions of independent trials\n", 100.0 * table.level);
  for (std::size_t row = 0; row < table.counts.rows.size(); ++row) {
    const auto& counted = table.counts.rows[row];
    text += fmt::format("\n{}{}k = {}, n = {}",
                        fmt::join(counted.labels, ", "),
                        counted.labels.empty() ? "" : ": ",
                        counted.successes,
                        counted.trials);
    const auto part = proportion(counted);
    text += part ? fmt::format(", p = {:.4f}\n", *part) : ": no trials\n";
    for (std::size_t i = 0; part && i < kIntervalMethods.size(); ++i) {
      const auto& interval = table.intervals[row][i];
      text += fmt::format(
          "  {:<16}[{:.4f}, {:.4f}]\n", name(kIntervalMethods[i]), interval->low, interval->high);
    }
    if (const auto& sensitivity = table.sensitivities[row]) {
      text += fmt::format("  d' of a choice among {}: {:.3f}\n", *table.alternatives, *sensitivity);
    }
  }
  text += "\nOf trials pooled over participants or words all of these are far too narrow.\n";
  if (table.alternatives) text += "d': (k + 1/m) / (n + 1), so that 0 and 1 do no harm.\n";
  return text;
}

std::string counted_proportions_csv(const CountedProportions& table) {
  std::vector<std::string> names = table.counts.labels;
  names.insert(names.end(), {"k", "n", "proportion"});
  for (const auto method : kIntervalMethods) {
    names.push_back(fmt::format("{}_low", name(method)));
    names.push_back(fmt::format("{}_high", name(method)));
  }
  if (table.alternatives) names.emplace_back("d_prime");
  std::string text;
  append_csv(text, std::vector<CsvField>(names.begin(), names.end()));
  for (std::size_t row = 0; row < table.counts.rows.size(); ++row) {
    const auto& counted = table.counts.rows[row];
    std::vector<CsvField> line(counted.labels.begin(), counted.labels.end());
    line.insert(line.end(), {counted.successes, counted.trials, csv_number(proportion(counted))});
    for (const auto& interval : table.intervals[row]) {
      line.push_back(interval ? CsvField{interval->low} : CsvField{});
      line.push_back(interval ? CsvField{interval->high} : CsvField{});
    }
    if (table.alternatives) line.push_back(csv_number(table.sensitivities[row]));
    append_csv(text, line);
  }
  return text;
}

std::string counted_proportions_json(const CountedProportions& table) {
  Json json{{"level", table.level}, {"rows", Json::array()}};
  if (table.alternatives) json["alternatives"] = *table.alternatives;
  for (std::size_t row = 0; row < table.counts.rows.size(); ++row) {
    const auto& counted = table.counts.rows[row];
    Json entry{{"labels", labels_of(table.counts.labels, counted.labels)},
               {"k", counted.successes},
               {"n", counted.trials},
               {"proportion", optional_json(proportion(counted))}};
    for (std::size_t i = 0; i < kIntervalMethods.size(); ++i) {
      const auto& interval = table.intervals[row][i];
      entry["intervals"][std::string{name(kIntervalMethods[i])}] = interval_json(interval);
    }
    if (table.alternatives) entry["d_prime"] = optional_json(table.sensitivities[row]);
    json["rows"].push_back(std::move(entry));
  }
  return json.dump(2) + "\n";
}

std::string yes_no_text(const YesTable& table) {
  std::string text = "Sensitivity and criterion of yes-no answers\n\n";
  for (const auto& row : table.rows) {
    text += fmt::format("{}{}hits {} of {}, false alarms {} of {}",
                        fmt::join(row.labels, ", "),
                        row.labels.empty() ? "" : ": ",
                        row.hits,
                        row.signals,
                        row.false_alarms,
                        row.noises);
    const auto found = yes_no(row.hits, row.signals, row.false_alarms, row.noises);
    text += found ? fmt::format(": d' = {:.3f}, c = {:.3f}\n", found->sensitivity, found->criterion)
                  : ": without trials of both kinds there is no d'\n";
  }
  return text +
         "\nLog-linear: 1/2 added to each count, 1 to each number of trials (Hautus, 1995).\n";
}

std::string yes_no_csv(const YesTable& table) {
  std::vector<std::string> names = table.labels;
  names.insert(names.end(), {"hits", "signals", "false_alarms", "noises", "d_prime", "criterion"});
  std::string text;
  append_csv(text, std::vector<CsvField>(names.begin(), names.end()));
  for (const auto& row : table.rows) {
    const auto found = yes_no(row.hits, row.signals, row.false_alarms, row.noises);
    std::vector<CsvField> line(row.labels.begin(), row.labels.end());
    line.insert(line.end(), {row.hits, row.signals, row.false_alarms, row.noises});
    line.push_back(found ? CsvField{found->sensitivity} : CsvField{});
    line.push_back(found ? CsvField{found->criterion} : CsvField{});
    append_csv(text, line);
  }
  return text;
}

std::string yes_no_json(const YesTable& table) {
  Json json{{"rows", Json::array()}};
  for (const auto& row : table.rows) {
    const auto found = yes_no(row.hits, row.signals, row.false_alarms, row.noises);
    json["rows"].push_back({{"labels", labels_of(table.labels, row.labels)},
                            {"hits", row.hits},
                            {"signals", row.signals},
                            {"false_alarms", row.false_alarms},
                            {"noises", row.noises},
                            {"d_prime", found ? Json(found->sensitivity) : Json()},
                            {"criterion", found ? Json(found->criterion) : Json()}});
  }
  return json.dump(2) + "\n";
}

}  // namespace bimodal::analysis

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "analysis/cli/output_form.hpp"
#include "analysis/cli/verb.hpp"
#include "analysis/data/counts_file.hpp"
#include "analysis/report/csv.hpp"
#include "analysis/statistics/interval.hpp"
#include "stimuli/base/digest.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::ordered_json;

struct ProportionsRequest {
  std::filesystem::path counts;
  double level = 0.95;
  OutputForm form;
};

constexpr const char* kExamples = R"(Examples:
  bimodal-analysis proportions counts.csv
  bimodal-analysis proportions counts.csv --level 0.99 --json

The file has a column k (successes), a column n (trials) and any others, like
condition,k,n and visual,86,414. Each line gets five intervals; Wilson's is the one to
report of one participant. All five take the trials for independent: of trials pooled
over participants or words they are far too narrow, and `report` has a bootstrap over
both instead.)";

struct Row {
  const CountedSuccesses& counted;
  std::vector<std::optional<Interval>> intervals;  ///< in the order of kIntervalMethods
};

std::optional<double> proportion(const CountedSuccesses& counted) {
  if (counted.trials == 0) return std::nullopt;
  return static_cast<double>(counted.successes) / static_cast<double>(counted.trials);
}

std::string as_text(const std::vector<Row>& rows, double level) {
  auto text = fmt::format("{:g} % intervals of proportions of independent trials\n", 100.0 * level);
  for (const auto& [counted, intervals] : rows) {
    text += fmt::format("\n{}{}k = {}, n = {}",
                        fmt::join(counted.labels, ", "),
                        counted.labels.empty() ? "" : ": ",
                        counted.successes,
                        counted.trials);
    const auto part = proportion(counted);
    text += part ? fmt::format(", p = {:.4f}\n", *part) : ": no trials\n";
    for (std::size_t i = 0; part && i < kIntervalMethods.size(); ++i) {
      text += fmt::format("  {:<16}[{:.4f}, {:.4f}]\n",
                          name(kIntervalMethods[i]),
                          intervals[i]->low,
                          intervals[i]->high);
    }
  }
  return text + "\nOf trials pooled over participants or words all of these are far too narrow.\n";
}

std::string as_csv(const std::vector<Row>& rows, const CountsTable& table) {
  std::vector<std::string> names = table.labels;
  names.insert(names.end(), {"k", "n", "proportion"});
  for (const auto method : kIntervalMethods) {
    names.push_back(fmt::format("{}_low", name(method)));
    names.push_back(fmt::format("{}_high", name(method)));
  }
  std::string text;
  append_csv(text, std::vector<CsvField>(names.begin(), names.end()));
  for (const auto& [counted, intervals] : rows) {
    std::vector<CsvField> line(counted.labels.begin(), counted.labels.end());
    line.insert(line.end(), {counted.successes, counted.trials});
    const auto part = proportion(counted);
    line.push_back(part ? CsvField{*part} : CsvField{});
    for (const auto& interval : intervals) {
      line.push_back(interval ? CsvField{interval->low} : CsvField{});
      line.push_back(interval ? CsvField{interval->high} : CsvField{});
    }
    append_csv(text, line);
  }
  return text;
}

std::string as_json(const std::vector<Row>& rows, const CountsTable& table, double level) {
  Json json{{"level", level}, {"rows", Json::array()}};
  for (const auto& [counted, intervals] : rows) {
    Json row{{"labels", Json::object()}, {"k", counted.successes}, {"n", counted.trials}};
    for (std::size_t i = 0; i < table.labels.size(); ++i) {
      row["labels"][table.labels[i]] = counted.labels[i];
    }
    const auto part = proportion(counted);
    row["proportion"] = part ? Json(*part) : Json();
    for (std::size_t i = 0; i < kIntervalMethods.size(); ++i) {
      row["intervals"][std::string{name(kIntervalMethods[i])}] =
          intervals[i] ? Json{intervals[i]->low, intervals[i]->high} : Json();
    }
    json["rows"].push_back(std::move(row));
  }
  return json.dump(2) + "\n";
}

ExitCode print_proportions(const ProportionsRequest& request, Console console) {
  const auto table = read_counts(request.counts);
  std::vector<Row> rows;
  for (const auto& counted : table.rows) {
    Row row{.counted = counted, .intervals = {}};
    for (const auto method : kIntervalMethods) {
      row.intervals.push_back(
          interval_of(method, counted.successes, counted.trials, request.level));
    }
    rows.push_back(std::move(row));
  }
  return print_as(request.form,
                  {.text = [&] { return as_text(rows, request.level); },
                   .csv = [&] { return as_csv(rows, table); },
                   .json = [&] { return as_json(rows, table, request.level); }},
                  Provenance{.program = program_name(),
                             .files = {{request.counts.string(), sha256_of_file(request.counts)}}},
                  {},
                  console);
}

}  // namespace

void add_proportions_verb(CLI::App& program, Verb& chosen) {
  const auto request = std::make_shared<ProportionsRequest>();
  auto* const verb =
      program.add_subcommand("proportions", "Intervals of proportions: k of n, line by line");
  verb->footer(kExamples);
  verb->add_option("COUNTS", request->counts, "CSV with the columns k and n")->required();
  verb->add_option("--level", request->level, "Of confidence")
      ->capture_default_str()
      ->check(CLI::Range(0.5, 0.9999));
  add_output_form(*verb, request->form);
  verb->callback([request, &chosen] {
    chosen = [request](Console console) { return print_proportions(*request, console); };
  });
}

}  // namespace bimodal::analysis

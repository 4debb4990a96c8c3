#include "analysis/report/proportion_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "analysis/report/csv.hpp"
#include "analysis/report/json_count.hpp"
#include "analysis/report/printed_number.hpp"
#include "analysis/statistics/discrimination.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::ordered_json;

/// Choices are made of words, not of phonemes.
std::optional<double> sensitivity_of(const ProportionTable& table, const Proportion& row) {
  if (!table.alternatives || row.measure != Measure::Word) return std::nullopt;
  return sensitivity_of_choices(row.correct, row.judged, *table.alternatives);
}

std::string interval_text(const Proportion& row) {
  if (!row.interval) return "-";
  return fmt::format(
      "[{}, {}]", print_proportion(row.interval->low), print_proportion(row.interval->high));
}

}  // namespace

std::string proportion_text(const ProportionTable& table) {
  std::size_t condition = 9;
  std::size_t participant = 11;
  for (const auto& row : table.rows) {
    condition = std::max(condition, row.condition.size());
    participant = std::max(participant, row.participant.size());
  }
  auto text = fmt::format(
      "Proportions correct, 95 % intervals\n\n  {:<18}  {:<{}}  {:<{}}{:>9}{:>8}"
      "{:>7}  {:<12}{}  interval by\n",
      "of",
      "condition",
      condition,
      "participant",
      participant,
      "correct",
      "judged",
      "p",
      "95 %",
      table.alternatives ? "      d'" : "");
  for (const auto& row : table.rows) {
    const auto sensitivity = sensitivity_of(table, row);
    text += fmt::format("  {:<18}  {:<{}}  {:<{}}{:>9}{:>8}{:>7}  {:<12}{}  {}\n",
                        name(row.measure),
                        row.condition,
                        condition,
                        row.participant.empty() ? "(all)" : row.participant,
                        participant,
                        row.correct,
                        row.judged,
                        row.proportion ? print_proportion(*row.proportion) : "-",
                        interval_text(row),
                        !table.alternatives ? ""
                        : sensitivity       ? fmt::format("{:>8.3f}", *sensitivity)
                                            : fmt::format("{:>8}", "-"),
                        row.method);
  }
  return text;
}

std::string proportion_csv(const ProportionTable& table) {
  std::string text;
  std::vector<CsvField> line;
  for (const std::string_view column : {"measure",
                                        "condition",
                                        "participant",
                                        "participants",
                                        "words",
                                        "correct",
                                        "judged",
                                        "proportion",
                                        "low",
                                        "high",
                                        "method",
                                        "d_prime"}) {
    line.emplace_back(column);
  }
  append_csv(text, line);
  for (const auto& row : table.rows) {
    const auto sensitivity = sensitivity_of(table, row);
    line.assign({name(row.measure),
                 std::string_view{row.condition},
                 row.participant.empty() ? CsvField{} : CsvField{std::string_view{row.participant}},
                 row.participants,
                 row.words,
                 row.correct,
                 row.judged,
                 csv_number(row.proportion),
                 row.interval ? CsvField{row.interval->low} : CsvField{},
                 row.interval ? CsvField{row.interval->high} : CsvField{},
                 std::string_view{row.method},
                 csv_number(sensitivity)});
    append_csv(text, line);
  }
  return text;
}

Json proportion_json(const ProportionTable& table) {
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json entry{{"measure", name(row.measure)},
               {"condition", row.condition},
               {"participant", row.participant.empty() ? Json() : Json(row.participant)},
               {"participants", row.participants},
               {"words", row.words},
               {"correct", row.correct},
               {"judged", row.judged},
               {"proportion", optional_json(row.proportion)},
               {"interval", interval_json(row.interval)},
               {"method", row.method}};
    if (table.alternatives) {
      const auto sensitivity = sensitivity_of(table, row);
      entry["d_prime"] = optional_json(sensitivity);
    }
    rows.push_back(std::move(entry));
  }
  return rows;
}

}  // namespace bimodal::analysis

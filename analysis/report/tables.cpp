#include "analysis/report/tables.hpp"

#include <map>
#include <optional>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/report/columns.hpp"
#include "analysis/report/comparison_table.hpp"
#include "analysis/report/csv.hpp"
#include "stimuli/base/milliseconds.hpp"

namespace bimodal::analysis {

namespace {

/// A table whose header is what columns.csv says about it.
class Table {
 public:
  explicit Table(std::string_view name) : file_{std::string{name} + ".csv", {}} {
    std::vector<CsvField> header;
    for (const auto& column : columns_of(name)) header.emplace_back(column.name);
    append_csv(file_.content, header);
  }

  void add(std::initializer_list<CsvField> row) {
    append_csv(file_.content, {row.begin(), row.size()});
  }

  ReportFile take() && { return std::move(file_); }

 private:
  ReportFile file_;
};

CsvField text(const std::string& value) {
  return std::string_view{value};
}

CsvField text(const std::optional<std::string>& value) {
  return value ? CsvField{std::string_view{*value}} : CsvField{};
}

template <typename Integer>
CsvField count(Integer value) {
  return static_cast<std::int64_t>(value);
}

CsvField optional_milliseconds(const std::optional<Duration>& value) {
  if (!value) return {};
  return milliseconds(*value);
}

CsvField answered(const std::optional<UnitScore>& unit) {
  if (!unit) return {};
  switch (unit->outcome) {
    case UnitScore::Outcome::Answered:
      return symbol(unit->answer);
    case UnitScore::Outcome::Deleted:
      return kDeleted;
    case UnitScore::Outcome::Blank:
      return kBlank;
    case UnitScore::Outcome::Other:
      return kOther;
    case UnitScore::Outcome::Ambiguous:
      break;
  }
  return std::string_view{"ambiguous"};
}

ReportFile trials_table(const Results& results) {
  Table table{"trials"};
  for (std::size_t i = 0; i < results.dataset.trials.size(); ++i) {
    const auto& trial = results.dataset.trials[i];
    const auto& score = results.scores[i];
    const auto& session = results.dataset.sessions[trial.session];
    const auto phones = spell(trial.phones);
    table.add({text(trial.participant),
               count(session.session_number),
               count(session.file + 1),
               count(session.id),
               count(trial.trial),
               text(trial.phase),
               count(trial.block),
               text(trial.condition),
               text(trial.auditory_talker),
               text(trial.visual_talker),
               csv_number(trial.snr_db),
               text(trial.word),
               text(trial.visual_word),
               text(trial.articulation),
               text(phones),
               text(trial.response),
               text(score.answer),
               name(score.verdict),
               count(score.word_correct() ? 1 : 0),
               count(score.phones),
               score.phones_correct ? count(*score.phones_correct) : CsvField{},
               answered(score.units[0]),
               answered(score.units[1]),
               answered(score.units[2]),
               optional_milliseconds(trial.first_key),
               optional_milliseconds(trial.submitted),
               count(trial.timed_out ? 1 : 0),
               trial.timing_known ? count(trial.flagged ? 1 : 0) : CsvField{},
               count(trial.simulated ? 1 : 0)});
  }
  return std::move(table).take();
}

ReportFile words_table(const Results& results) {
  struct Tally {
    std::string phones;
    std::int64_t trials = 0;
    std::int64_t correct = 0;
    std::int64_t phonemes = 0;
    std::int64_t phonemes_correct = 0;
  };

  std::map<std::tuple<std::string_view, std::string_view>, Tally> tallies;
  for (std::size_t i = 0; i < results.dataset.trials.size(); ++i) {
    const auto& trial = results.dataset.trials[i];
    const auto& score = results.scores[i];
    auto& tally = tallies[{trial.word, trial.condition}];
    tally.phones = spell(trial.phones);
    ++tally.trials;
    tally.correct += score.word_correct() ? 1 : 0;
    if (!score.phones_correct) continue;
    tally.phonemes += score.phones;
    tally.phonemes_correct += *score.phones_correct;
  }
  Table table{"words"};
  for (const auto& [key, tally] : tallies) {
    table.add({std::get<0>(key),
               text(tally.phones),
               std::get<1>(key),
               count(tally.trials),
               count(tally.correct),
               static_cast<double>(tally.correct) / static_cast<double>(tally.trials),
               count(tally.phonemes),
               count(tally.phonemes_correct)});
  }
  return std::move(table).take();
}

ReportFile proportions_table(const Results& results) {
  Table table{"proportions"};
  const auto add = [&](const Proportion& row) {
    const auto low = row.interval ? CsvField{row.interval->low} : CsvField{};
    const auto high = row.interval ? CsvField{row.interval->high} : CsvField{};
    const bool pooled = row.participant.empty();
    table.add({name(row.measure),
               text(row.condition),
               std::string_view{pooled ? "pooled" : "participant"},
               pooled ? CsvField{} : text(row.participant),
               count(row.participants),
               count(row.words),
               count(row.correct),
               count(row.judged),
               csv_number(row.proportion),
               low,
               high,
               text(row.method)});
  };
  for (const auto& row : results.pooled) add(row);
  for (const auto& row : results.individual) add(row);
  return std::move(table).take();
}

ReportFile confusions_table(const Results& results) {
  Table table{"confusions"};
  for (const auto& confusions : results.confusions) {
    const auto& matrix = confusions.matrix;
    for (std::size_t i = 0; i < matrix.stimuli().size(); ++i) {
      for (std::size_t j = 0; j < matrix.responses().size(); ++j) {
        table.add({text(confusions.condition),
                   name(confusions.unit),
                   text(matrix.stimuli()[i]),
                   text(matrix.responses()[j]),
                   matrix.count(i, j),
                   matrix.row_total(i),
                   csv_number(matrix.proportion(i, j))});
      }
    }
  }
  return std::move(table).take();
}

ReportFile likeness_table(const Results& results) {
  Table table{"likeness"};
  for (const auto& row : results.likeness) {
    table.add({name(row.unit),
               text(row.one),
               text(row.other),
               row.trials_of_one,
               row.trials_of_other,
               count(row.likeness.cells),
               count(row.likeness.cells_used),
               csv_number(row.likeness.correlation),
               csv_number(row.likeness.rms_deviation)});
  }
  return std::move(table).take();
}

ReportFile benefits_table(const Results& results) {
  Table table{"benefits"};
  const auto low = [](const std::optional<Interval>& interval) {
    return interval ? CsvField{interval->low} : CsvField{};
  };
  const auto high = [](const std::optional<Interval>& interval) {
    return interval ? CsvField{interval->high} : CsvField{};
  };
  for (const auto& row : results.benefits) {
    table.add({text(row.bimodal),
               text(row.auditory),
               row.visual.empty() ? CsvField{} : text(row.visual),
               count(row.participants),
               count(row.words),
               count(row.n_auditory),
               count(row.n_visual),
               count(row.n),
               row.a,
               csv_number(row.v),
               row.av,
               row.benefit.gain,
               low(row.gain_interval),
               high(row.gain_interval),
               csv_number(row.benefit.relative),
               low(row.relative_interval),
               high(row.relative_interval),
               csv_number(row.benefit.log_odds),
               csv_number(row.benefit.excess),
               text(row.method)});
  }
  return std::move(table).take();
}

ReportFile comparison_table(const Results& results) {
  Table table{"comparison"};
  for (const auto& comparison : results.comparisons) {
    const auto& one = comparison.one_matrix;
    const auto& other = comparison.other_matrix;
    for (std::size_t i = 0; i < one.stimuli().size(); ++i) {
      for (std::size_t j = 0; j < one.responses().size(); ++j) {
        const auto cell = i * one.responses().size() + j;
        table.add({name(comparison.unit.value()),
                   text(comparison.one),
                   text(comparison.other),
                   text(one.stimuli()[i]),
                   text(one.responses()[j]),
                   one.count(i, j),
                   other.count(i, j),
                   csv_number(one.proportion(i, j)),
                   csv_number(other.proportion(i, j)),
                   csv_number(comparison.permutation.cell_p.at(cell)),
                   csv_number(comparison.permutation.cell_q.at(cell))});
      }
    }
  }
  return std::move(table).take();
}

ReportFile contrasts_table(const Results& results) {
  Table table{"contrasts"};
  for (const auto& comparison : results.comparisons) {
    for (const auto& contrast : comparison.contrasts) {
      table.add({name(comparison.unit.value()),
                 text(contrast.stimulus),
                 text(contrast.counterpart),
                 contrast.one,
                 contrast.other,
                 contrast.loss(),
                 contrast.confused_one,
                 contrast.confused_other,
                 contrast_in_words(contrast, comparison.one, comparison.other)});
    }
  }
  return std::move(table).take();
}

ReportFile exclusions_table(const Results& results) {
  Table table{"exclusions"};
  const auto add = [&](std::string_view what, std::string_view condition, std::int64_t number) {
    table.add({what, condition.empty() ? CsvField{} : CsvField{condition}, count(number)});
  };
  add("stored trials", {}, results.dataset.stored_trials);
  for (const auto& exclusion : results.dataset.exclusions) {
    add("left out: " + exclusion.reason, {}, exclusion.trials);
  }
  add("analysed trials", {}, static_cast<std::int64_t>(results.dataset.trials.size()));
  for (const auto& condition : results.conditions) {
    add("answers not in the dictionary", condition.name, condition.unknown);
    add("blank answers", condition.name, condition.omissions);
  }
  for (const auto& confusions : results.confusions) {
    add(fmt::format("ambiguous {}", name(confusions.unit)),
        confusions.condition,
        confusions.ambiguous);
  }
  return std::move(table).take();
}

ReportFile columns_table() {
  Table table{"columns"};
  for (const auto& column : all_columns()) {
    table.add({std::string{column.table} + ".csv", column.name, column.meaning});
  }
  return std::move(table).take();
}

ReportFile manifest(const Results& results, const Making& making) {
  nlohmann::ordered_json json;
  json["program"] = making.program;
  json["made_utc"] = making.made_utc;
  json["selection"] = making.selection;
  if (!making.command.empty()) json["command"] = making.command;
  json["bootstrap"] = {{"draws", results.bootstrap.draws}, {"seed", results.bootstrap.seed}};
  if (results.faces) {
    json["faces"] = {{"natural", results.faces->natural},
                     {"synthetic", results.faces->synthetic},
                     {"permutations", results.comparison.permutations},
                     {"splits", results.comparison.splits},
                     {"seed", results.comparison.seed}};
  }
  json["scoring"] = describe_rules(results.rules);
  json["dictionary"] = {{"file", results.dictionary.file}, {"sha256", results.dictionary.sha256}};
  json["data"] = nlohmann::ordered_json::array();
  for (const auto& file : results.dataset.files) {
    json["data"].push_back({{"file", file.name}, {"sha256", file.sha256}});
  }
  json["stored_trials"] = results.dataset.stored_trials;
  json["analysed_trials"] = results.dataset.trials.size();
  json["simulated"] = std::ranges::any_of(results.dataset.trials, &Trial::simulated);
  json["warnings"] = results.warnings;
  return {"manifest.json",
          json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n"};
}

}  // namespace

std::vector<ReportFile> report_tables(const Results& results, const Making& making) {
  std::vector<ReportFile> files;
  files.push_back(trials_table(results));
  files.push_back(words_table(results));
  files.push_back(proportions_table(results));
  files.push_back(benefits_table(results));
  files.push_back(confusions_table(results));
  files.push_back(likeness_table(results));
  if (results.faces) {
    files.push_back(comparison_table(results));
    files.push_back(contrasts_table(results));
  }
  files.push_back(exclusions_table(results));
  files.push_back(columns_table());
  files.push_back(manifest(results, making));
  return files;
}

}  // namespace bimodal::analysis

#include "analysis/report/score_table.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/report/csv.hpp"
#include "analysis/report/printed_number.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::ordered_json;
using Count = std::int64_t ScoreRow::*;
using Share = std::optional<double> (ScoreRow::*)() const;

/// A column of every form of the table: a count or a proportion.
struct Figure {
  std::string_view name;   ///< in CSV and JSON
  std::string_view title;  ///< in text
  Count count = nullptr;
  Share share = nullptr;
};

constexpr std::array kFigures = std::to_array<Figure>({
    {"n", "n", &ScoreRow::trials},
    {"exact", "exact", &ScoreRow::exact},
    {"homophone", "homophone", &ScoreRow::homophone},
    {"tolerated", "tolerated", &ScoreRow::tolerated},
    {"wrong", "wrong", &ScoreRow::wrong},
    {"omissions", "omitted", &ScoreRow::omissions},
    {"out_of_dictionary", "unknown", &ScoreRow::out_of_dictionary},
    {"word_proportion", "words", nullptr, &ScoreRow::word_proportion},
    {"no_pronunciation", "no phones", &ScoreRow::no_pronunciation},
    {"phonemes", "judged", &ScoreRow::phonemes},
    {"phonemes_correct", "correct", &ScoreRow::phonemes_correct},
    {"phoneme_proportion", "phonemes", nullptr, &ScoreRow::phoneme_proportion},
    {"insertions", "inserted", &ScoreRow::insertions},
    {"aligned", "aligned", &ScoreRow::aligned},
    {"ambiguous", "ambiguous", &ScoreRow::ambiguous},
    {"ambiguous_proportion", "share", nullptr, &ScoreRow::ambiguous_proportion},
});

std::optional<double> share_of(std::int64_t part, std::int64_t all) {
  if (all == 0) return std::nullopt;
  return static_cast<double>(part) / static_cast<double>(all);
}

Count count_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::Correct:
      return &ScoreRow::exact;
    case Verdict::Homophone:
      return &ScoreRow::homophone;
    case Verdict::Tolerated:
      return &ScoreRow::tolerated;
    case Verdict::Wrong:
      return &ScoreRow::wrong;
    case Verdict::Unknown:
      return &ScoreRow::out_of_dictionary;
    case Verdict::Omission:
      break;
  }
  return &ScoreRow::omissions;
}

void count(const Score& score, ScoreRow& row) {
  ++row.trials;
  ++(row.*count_of(score.verdict));
  if (score.phones == 0) ++row.no_pronunciation;
  if (score.phones_correct) {
    row.phonemes += score.phones;
    row.phonemes_correct += *score.phones_correct;
  }
  row.insertions += score.insertions;
  if (!score.said.empty()) ++row.aligned;
  if (score.ambiguous()) ++row.ambiguous;
}

std::string print(const Figure& figure, const ScoreRow& row) {
  if (figure.count != nullptr) return fmt::format("{}", row.*figure.count);
  const auto share = (row.*figure.share)();
  return share ? print_proportion(*share) : "-";
}

/// Columns as wide as they must be, the first one to the left, all others to the right.
std::string aligned(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(lines.front().size());
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  for (const auto& line : lines) {
    text += fmt::format("  {:<{}}", line.front(), widths.front());
    for (std::size_t i = 1; i < line.size(); ++i)
      text += fmt::format("  {:>{}}", line[i], widths[i]);
    text += '\n';
  }
  return text;
}

/// Figures first to last, of every row.
std::string lines_of(const ScoreTable& table, std::string_view first, std::string_view last) {
  const auto* const begin = std::ranges::find(kFigures, first, &Figure::name);
  const auto* const end = std::ranges::find(kFigures, last, &Figure::name) + 1;
  std::vector<std::vector<std::string>> lines{{"condition"}};
  for (const auto* figure = begin; figure != end; ++figure) {
    lines.front().emplace_back(figure->title);
  }
  const auto append = [&](const ScoreRow& row) {
    const bool all = row.participant.empty();
    auto& line = lines.emplace_back(
        std::vector{all ? row.condition : row.condition + ", " + row.participant});
    for (const auto* figure = begin; figure != end; ++figure) line.push_back(print(*figure, row));
  };
  for (const auto& row : table.conditions) append(row);
  for (const auto& row : table.participants) append(row);
  return aligned(lines);
}

Json as_json(const ScoreRow& row) {
  Json json{{"condition", row.condition}};
  if (!row.participant.empty()) json["participant"] = row.participant;
  for (const auto& figure : kFigures) {
    auto& value = json[std::string{figure.name}];
    if (figure.count != nullptr) {
      value = row.*figure.count;
    } else if (const auto share = (row.*figure.share)()) {
      value = *share;
    }
  }
  return json;
}

Json as_json(const ScoringRules& rules) {
  Json tolerate = Json::array();
  for (const Tolerance tolerance : kTolerances) {
    if (rules.tolerates(tolerance)) tolerate.push_back(name(tolerance));
  }
  return {{"homophones", rules.homophones},
          {"tolerate", std::move(tolerate)},
          {"out_of_dictionary", name(rules.out_of_dictionary)},
          {"costs", name(rules.costs)},
          {"ties", name(rules.ties)}};
}

/// A sentence a line.
std::string lines_of_rules(const ScoringRules& rules) {
  auto text = describe_rules(rules);
  for (auto at = text.find(". "); at != std::string::npos; at = text.find(". ", at)) {
    text[at + 1] = '\n';
  }
  return text;
}

void append_row(std::string& text, const ScoreRow& row) {
  std::vector<CsvField> line{std::string_view{row.condition}};
  line.push_back(row.participant.empty() ? CsvField{} : std::string_view{row.participant});
  for (const auto& figure : kFigures) {
    if (figure.count != nullptr) {
      line.emplace_back(row.*figure.count);
    } else {
      const auto share = (row.*figure.share)();
      line.push_back(share ? CsvField{*share} : CsvField{});
    }
  }
  append_csv(text, line);
}

}  // namespace

std::optional<double> ScoreRow::word_proportion() const {
  return share_of(exact + homophone + tolerated, trials);
}

std::optional<double> ScoreRow::phoneme_proportion() const {
  return share_of(phonemes_correct, phonemes);
}

std::optional<double> ScoreRow::ambiguous_proportion() const {
  return share_of(ambiguous, aligned);
}

ScoreTable tabulate_scores(std::span<const Trial> trials,
                           std::span<const Score> scores,
                           std::span<const std::string> conditions,
                           std::span<const std::string> participants,
                           const ScoringRules& rules) {
  assert(trials.size() == scores.size());
  std::map<std::pair<std::string_view, std::string_view>, ScoreRow> rows;  // all under ""
  for (std::size_t i = 0; i < trials.size(); ++i) {
    const auto& [condition, participant] = std::tie(trials[i].condition, trials[i].participant);
    count(scores[i], rows[{condition, ""}]);
    count(scores[i], rows[{condition, participant}]);
  }
  const auto row_of = [&](const std::string& condition, const std::string& participant) {
    auto row = rows[{condition, participant}];
    row.condition = condition;
    row.participant = participant;
    return row;
  };
  ScoreTable table{.rules = rules, .conditions = {}, .participants = {}};
  for (const auto& condition : conditions) {
    table.conditions.push_back(row_of(condition, ""));
    for (const auto& participant : participants) {
      auto row = row_of(condition, participant);
      if (row.trials > 0) table.participants.push_back(std::move(row));
    }
  }
  return table;
}

std::string score_text(const ScoreTable& table) {
  return fmt::format(
      "Answers\n\n{}\nPhonemes of the stimuli\n\n{}\n"
      "Note. {}\n"
      "n: trials; exact: spelled as the word; wrong: another word of the dictionary; unknown: not\n"
      "in the dictionary; words: proportion correct (exact, homophone and tolerated).\n"
      "no phones: trials of stimuli that nobody knows how to say; judged, correct: phonemes;\n"
      "inserted: phonemes of answers that stand against none; aligned: answers that are not\n"
      "correct, have phones, and so are aligned; ambiguous: of these, equally good alignments\n"
      "disagree on some phoneme.\n",
      lines_of(table, "n", "word_proportion"),
      lines_of(table, "no_pronunciation", "ambiguous_proportion"),
      lines_of_rules(table.rules));
}

std::string score_csv(const ScoreTable& table) {
  std::string text;
  std::vector<CsvField> header{std::string_view{"condition"}, std::string_view{"participant"}};
  for (const auto& figure : kFigures) header.emplace_back(figure.name);
  append_csv(text, header);
  for (const auto& row : table.conditions) append_row(text, row);
  for (const auto& row : table.participants) append_row(text, row);
  return text;
}

std::string score_json(const ScoreTable& table) {
  Json json{{"rules", as_json(table.rules)}, {"conditions", Json::array()}};
  for (const auto& row : table.conditions) json["conditions"].push_back(as_json(row));
  for (const auto& row : table.participants) json["participants"].push_back(as_json(row));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bimodal::analysis

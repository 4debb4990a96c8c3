#include "analysis/report/scored_trials.hpp"

#include <array>
#include <cassert>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/report/csv.hpp"
#include "analysis/report/printed_number.hpp"
#include "analysis/scoring/label_pair.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::ordered_json;
using Outcome = UnitScore::Outcome;

constexpr auto kColumns = std::to_array<std::string_view>({"participant",
                                                           "trial",
                                                           "condition",
                                                           "stimulus",
                                                           "response",
                                                           "answer",
                                                           "verdict",
                                                           "rule",
                                                           "word_correct",
                                                           "phones",
                                                           "answer_phones",
                                                           "alignment",
                                                           "phonemes",
                                                           "phonemes_correct",
                                                           "insertions"});

std::string_view partner_label(const Partner& partner) {
  return partner ? symbol(*partner) : kDeleted;
}

std::string shares_at(const Score& score, std::size_t place) {
  std::string text;
  for (const auto& share : score.shares) {
    if (share.place != place) continue;
    text += fmt::format("{}{}({})",
                        text.empty() ? "" : "/",
                        partner_label(share.partner),
                        print_proportion(share.share));
  }
  return text;
}

std::string partner_at(const Score& score, std::size_t place) {
  const auto& found = score.places[place];
  switch (found.outcome) {
    case Outcome::Answered:
      return std::string{symbol(found.answer)};
    case Outcome::Deleted:
      return std::string{kDeleted};
    case Outcome::Blank:
      return std::string{kBlank};
    case Outcome::Other:
      return std::string{kOther};
    case Outcome::Ambiguous:
      break;
  }
  return shares_at(score, place);
}

/// "T UW", several ways as "R EH D or R IY D"; of a correct word the phones presented.
std::string answer_phones(const Trial& trial, const Score& score) {
  if (score.word_correct()) return spell(trial.phones);
  std::string text;
  for (const auto& said : score.said) {
    if (!text.empty()) text += " or ";
    text += spell(said.phones);
  }
  return text;
}

/// The columns of one trial; text and numbers as JSON has them, null where absent.
std::array<Json, kColumns.size()> values_of(const Trial& trial, const Score& score) {
  const bool has_phones = score.phones > 0;
  return {trial.participant,
          trial.trial,
          trial.condition,
          trial.word,
          trial.response,
          score.answer,
          name(score.verdict),
          score.tolerance ? Json(name(*score.tolerance)) : Json(),
          score.word_correct() ? 1 : 0,
          has_phones ? Json(spell(trial.phones)) : Json(),
          has_phones ? Json(answer_phones(trial, score)) : Json(),
          has_phones ? Json(print_alignment(score)) : Json(),
          score.phones,
          score.phones_correct ? Json(*score.phones_correct) : Json(),
          score.phones_correct ? Json(score.insertions) : Json()};
}

CsvField csv_field(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return std::string_view{value.get_ref<const std::string&>()};
  return value.get<std::int64_t>();
}

/// Tabs and line ends in answers would break the lines.
std::string one_line(const Json& value) {
  if (value.is_null()) return {};
  if (!value.is_string()) return fmt::format("{}", value.get<std::int64_t>());
  auto text = value.get<std::string>();
  for (char& letter : text) {
    if (letter == '\t' || letter == '\n' || letter == '\r') letter = ' ';
  }
  return text;
}

}  // namespace

std::string print_alignment(const Score& score) {
  std::string text;
  for (std::size_t place = 0; place < score.places.size(); ++place) {
    text += fmt::format("{}{}>{}",
                        text.empty() ? "" : " ",
                        symbol(score.places[place].stimulus),
                        partner_at(score, place));
  }
  return text;
}

std::string scored_trials_text(std::span<const Trial> trials, std::span<const Score> scores) {
  assert(trials.size() == scores.size());
  std::string text;
  for (const auto column : kColumns) text += fmt::format("{}{}", text.empty() ? "" : "\t", column);
  text += '\n';
  for (std::size_t i = 0; i < trials.size(); ++i) {
    std::string line;
    for (const auto& value : values_of(trials[i], scores[i])) line += one_line(value) + '\t';
    line.back() = '\n';
    text += line;
  }
  return text;
}

std::string scored_trials_csv(std::span<const Trial> trials, std::span<const Score> scores) {
  assert(trials.size() == scores.size());
  std::string text;
  append_csv(text, std::vector<CsvField>{kColumns.begin(), kColumns.end()});
  for (std::size_t i = 0; i < trials.size(); ++i) {
    std::vector<CsvField> line;
    const auto values = values_of(trials[i], scores[i]);
    for (const auto& value : values) line.push_back(csv_field(value));
    append_csv(text, line);
  }
  return text;
}

std::string scored_trials_json(std::span<const Trial> trials, std::span<const Score> scores) {
  assert(trials.size() == scores.size());
  Json json{{"trials", Json::array()}};
  for (std::size_t i = 0; i < trials.size(); ++i) {
    auto values = values_of(trials[i], scores[i]);
    Json row;
    for (std::size_t column = 0; column < kColumns.size(); ++column) {
      row[std::string{kColumns.at(column)}] = std::move(values.at(column));
    }
    json["trials"].push_back(std::move(row));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bimodal::analysis

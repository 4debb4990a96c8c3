#include <iterator>
#include <string_view>
#include <unordered_map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "analysis/report/page_parts.hpp"
#include "analysis/scoring/label_pair.hpp"
#include "stimuli/timeline/phone.hpp"

namespace bimodal::analysis {

namespace {

using Json = nlohmann::json;

/// Texts that are written once and referred to by number.
class Texts {
 public:
  std::size_t of(const std::string& text) {
    const auto [at, is_new] = numbers_.try_emplace(text, texts_.size());
    if (is_new) texts_.push_back(text);
    return at->second;
  }

  [[nodiscard]] const std::vector<std::string>& all() const { return texts_; }

 private:
  std::unordered_map<std::string, std::size_t> numbers_;
  std::vector<std::string> texts_;
};

/// Appends where a trial stands in the matrix of a unit: one column, or several that share it; -1:
/// in none.
void add_responses(
    const Trial& trial, const Score& score, Unit unit, Texts& labels, std::string& row) {
  const auto pairs = confusions_of(trial, score, unit);
  if (pairs.empty()) {
    row += "-1";
  } else if (pairs.size() == 1) {
    row += std::to_string(labels.of(pairs.front().response));
  } else {
    row += '[';
    for (const auto& pair : pairs) {
      if (row.back() != '[') row += ',';
      row += std::to_string(labels.of(pair.response));
    }
    row += ']';
  }
}

/// The word with its labels in the units, -1 where it has none.
Json word_of(const Trial& trial, Texts& labels) {
  Json word{trial.word};
  for (const Unit unit : kPlaceUnits) {
    const auto stimuli = stimuli_of(trial, unit);
    word.push_back(stimuli.empty() ? Json(-1) : Json(labels.of(stimuli.front())));
  }
  return word;
}

/// As JSON without the letters that XML would read as markup, which JSON can write otherwise.
std::string without_markup(const Json& json) {
  std::string text;
  for (const char letter : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (letter == '<' || letter == '>' || letter == '&') {
      text += fmt::format("\\u{:04x}", static_cast<unsigned>(letter));
    } else if (letter == '\x7f') {
      text += "\\u007f";
    } else {
      text += letter;
    }
  }
  return text;
}

/// What the script needs as JSON. The trials, of which there may be a million, are written as text
/// at once: as values they would take several times as much memory.
std::string data_of(const Results& results) {
  Texts participants;
  Texts conditions;
  Texts words;
  Texts answers;
  Texts labels;
  Json word_rows = Json::array();
  std::string trials;
  for (std::size_t i = 0; i < results.dataset.trials.size(); ++i) {
    const auto& trial = results.dataset.trials[i];
    const auto word = words.of(trial.word + '\n' + spell(trial.phones));
    if (word == word_rows.size()) word_rows.push_back(word_of(trial, labels));
    const std::string_view flagged = trial.flagged ? "1" : "0";
    fmt::format_to(std::back_inserter(trials),
                   "{}[{},{},{},{},{},{}",
                   i == 0 ? "" : ",",
                   participants.of(trial.participant),
                   conditions.of(trial.condition),
                   word,
                   answers.of(trial.response),
                   trial.trial,
                   trial.timing_known ? flagged : "null");
    for (const Unit unit : kPlaceUnits) {
      trials += ',';
      add_responses(trial, results.scores[i], unit, labels, trials);
    }
    trials += ']';
  }
  Json units = Json::array();
  for (const Unit unit : kPlaceUnits) units.push_back(name(unit));
  return fmt::format(
      R"({{"units":{},"labels":{},"participants":{},"conditions":{},"answers":{},"words":{},"trials":[{}]}})",
      without_markup(units),
      without_markup(labels.all()),
      without_markup(participants.all()),
      without_markup(conditions.all()),
      without_markup(answers.all()),
      without_markup(word_rows),
      trials);
}

}  // namespace

std::string part_of_trials(const Results& results) {
  return fmt::format(
      "<p id='told' class='note' role='status' aria-live='polite'></p>\n"
      "<script type='application/json' id='trial-data'>{}</script>\n<script>{}</script>\n",
      data_of(results),
      page_script());
}

}  // namespace bimodal::analysis

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

constexpr int kNone = -1;

/// Where a trial stands in the matrix of a unit: one column, or several that share it; -1: in none.
Json responses_of(const Trial& trial, const Score& score, Unit unit, Texts& labels) {
  const auto pairs = confusions_of(trial, score, unit);
  if (pairs.empty()) return kNone;
  if (pairs.size() == 1) return labels.of(pairs.front().response);
  Json several = Json::array();
  for (const auto& pair : pairs) several.push_back(labels.of(pair.response));
  return several;
}

/// The word with its labels in the units, -1 where it has none.
Json word_of(const Trial& trial, Texts& labels) {
  Json word{trial.word};
  for (const Unit unit : kPlaceUnits) {
    const auto stimuli = stimuli_of(trial, unit);
    word.push_back(stimuli.empty() ? Json(kNone) : Json(labels.of(stimuli.front())));
  }
  return word;
}

Json data_of(const Results& results) {
  Texts participants;
  Texts conditions;
  Texts words;
  Texts answers;
  Texts labels;
  Json word_rows = Json::array();
  Json trials = Json::array();
  for (std::size_t i = 0; i < results.dataset.trials.size(); ++i) {
    const auto& trial = results.dataset.trials[i];
    const auto word = words.of(trial.word + '\n' + spell(trial.phones));
    if (word == word_rows.size()) word_rows.push_back(word_of(trial, labels));
    Json row{participants.of(trial.participant),
             conditions.of(trial.condition),
             word,
             answers.of(trial.response),
             trial.trial,
             trial.timing_known ? Json(trial.flagged ? 1 : 0) : Json(nullptr)};
    for (const Unit unit : kPlaceUnits) {
      row.push_back(responses_of(trial, results.scores[i], unit, labels));
    }
    trials.push_back(std::move(row));
  }
  Json units = Json::array();
  for (const Unit unit : kPlaceUnits) units.push_back(name(unit));
  return {{"units", units},
          {"labels", labels.all()},
          {"participants", participants.all()},
          {"conditions", conditions.all()},
          {"answers", answers.all()},
          {"words", word_rows},
          {"trials", trials}};
}

/// Without the letters that XML would read as markup, which JSON can write otherwise.
std::string without_markup(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char letter : json) {
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

}  // namespace

std::string part_of_trials(const Results& results) {
  const auto json = data_of(results).dump(-1, ' ', false, Json::error_handler_t::replace);
  return fmt::format(
      "<p id='told' class='note' role='status' aria-live='polite'></p>\n"
      "<script type='application/json' id='trial-data'>{}</script>\n<script>{}</script>\n",
      without_markup(json),
      page_script());
}

}  // namespace bimodal::analysis

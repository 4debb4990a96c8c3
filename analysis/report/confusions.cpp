#include "analysis/report/confusions.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace bimodal::analysis {

namespace {

/// Numbers for labels, in the order in which they are met.
class LabelNumbers {
 public:
  std::size_t of(const std::string& label) {
    const auto [at, is_new] = numbers_.try_emplace(label, labels_.size());
    if (is_new) labels_.push_back(label);
    return at->second;
  }

  [[nodiscard]] const std::vector<std::string>& labels() const { return labels_; }

 private:
  std::unordered_map<std::string, std::size_t> numbers_;
  std::vector<std::string> labels_;
};

std::vector<std::string_view> extra_responses(Unit unit) {
  if (unit == Unit::Word) return {kBlank};
  if (unit == Unit::Onset || unit == Unit::Coda) return {kBlank, kOther};
  return {kDeleted, kBlank, kOther};
}

/// "S T" as phones; nothing for "none".
Pronunciation phones_in(std::string_view label) {
  Pronunciation phones;
  while (!label.empty()) {
    const auto part = label.substr(0, label.find(' '));
    label.remove_prefix(std::min(part.size() + 1, label.size()));
    if (const auto phone = phone_from_symbol(part)) phones.push_back(*phone);
  }
  return phones;
}

std::vector<std::string> in_order(std::vector<std::string> labels, Unit unit) {
  if (unit == Unit::Word) {
    std::ranges::sort(labels);
  } else {
    std::ranges::sort(labels, {}, [](const std::string& label) { return phones_in(label); });
  }
  return labels;
}

/// The trials of one unit, counted while they pass.
class UnitCount {
 public:
  UnitCount(Unit unit, std::span<const std::string> conditions)
      : unit_{unit}, conditions_{conditions}, tables_(conditions.size()) {
    for (const auto extra : extra_responses(unit)) labels_.of(std::string{extra});
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      tables_[i].unit = unit;
      tables_[i].condition = conditions[i];
    }
  }

  void add(const Trial& trial, const Score& score) {
    const auto stimuli = stimuli_of(trial, unit_);
    const auto pairs = confusions_of(trial, score, unit_);
    for (const auto& stimulus : stimuli) is_stimulus_.insert(labels_.of(stimulus));
    for (const auto& pair : pairs) labels_.of(pair.response);
    const auto condition = std::ranges::find(conditions_, trial.condition);
    if (condition == conditions_.end()) return;
    const auto at = static_cast<std::size_t>(condition - conditions_.begin());
    auto& table = tables_[at];
    if (stimuli.empty()) ++table.lacking;
    if (stimuli.empty() && trial.phones.empty()) ++table.without_phones;
    double counted = 0.0;
    for (const auto& pair : pairs) {
      cells_[{at, labels_.of(pair.stimulus), labels_.of(pair.response)}] += pair.weight;
      counted += pair.weight;
    }
    table.ambiguous += std::llround(static_cast<double>(stimuli.size()) - counted);
  }

  std::vector<UnitConfusions> take() && {
    const auto [rows, columns] = axes();
    for (auto& table : tables_) table.matrix = ConfusionMatrix{rows, columns};
    for (const auto& [cell, count] : cells_) {
      const auto& [condition, stimulus, response] = cell;
      tables_[condition].matrix.add(labels_.labels()[stimulus], labels_.labels()[response], count);
    }
    return std::move(tables_);
  }

 private:
  struct Axes {
    std::vector<std::string> stimuli;
    std::vector<std::string> responses;
  };

  [[nodiscard]] Axes axes() const {
    const auto extras = extra_responses(unit_);
    std::vector<std::string> stimuli;
    for (const auto number : is_stimulus_) stimuli.push_back(labels_.labels()[number]);
    const auto own = std::span{labels_.labels()}.subspan(extras.size());
    auto responses = in_order({own.begin(), own.end()}, unit_);
    responses.insert(responses.end(), extras.begin(), extras.end());
    return {in_order(std::move(stimuli), unit_), std::move(responses)};
  }

  Unit unit_;
  std::span<const std::string> conditions_;
  LabelNumbers labels_;
  std::set<std::size_t> is_stimulus_;
  std::map<std::array<std::size_t, 3>, double> cells_;  ///< by condition, stimulus, response
  std::vector<UnitConfusions> tables_;
};

}  // namespace

std::vector<UnitConfusions> tabulate_unit(std::span<const Trial> trials,
                                          std::span<const Score> scores,
                                          std::span<const std::string> conditions,
                                          Unit unit) {
  assert(trials.size() == scores.size());
  UnitCount count{unit, conditions};
  for (std::size_t i = 0; i < trials.size(); ++i) count.add(trials[i], scores[i]);
  return std::move(count).take();
}

std::vector<UnitConfusions> tabulate_confusions(std::span<const Trial> trials,
                                                std::span<const Score> scores,
                                                std::span<const std::string> conditions) {
  std::vector<UnitConfusions> tables;
  for (const Unit unit : kPlaceUnits) {
    for (auto& table : tabulate_unit(trials, scores, conditions, unit)) {
      tables.push_back(std::move(table));
    }
  }
  return tables;
}

std::vector<ConditionLikeness> compare_conditions(std::span<const UnitConfusions> confusions) {
  const std::vector<std::string> ignored{std::string{kBlank}, std::string{kOther}};
  std::vector<ConditionLikeness> compared;
  for (std::size_t i = 0; i < confusions.size(); ++i) {
    for (std::size_t j = i + 1; j < confusions.size(); ++j) {
      const auto& one = confusions[i];
      const auto& other = confusions[j];
      if (one.unit != other.unit) continue;
      compared.push_back({.unit = one.unit,
                          .one = one.condition,
                          .other = other.condition,
                          .trials_of_one = one.matrix.total(),
                          .trials_of_other = other.matrix.total(),
                          .likeness = compare_errors(one.matrix, other.matrix, ignored)});
    }
  }
  return compared;
}

}  // namespace bimodal::analysis

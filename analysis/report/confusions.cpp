#include "analysis/report/confusions.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <numeric>
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
    const auto stimuli = in_order({is_stimulus_.begin(), is_stimulus_.end()});
    const auto responses = ordered_responses();
    const auto rows = places_of(stimuli);
    const auto columns = places_of(responses);
    std::vector<std::vector<double>> counts(tables_.size(),
                                            std::vector<double>(stimuli.size() * responses.size()));
    for (const auto& [cell, count] : cells_) {
      const auto& [condition, stimulus, response] = cell;
      counts[condition][rows[stimulus] * responses.size() + columns[response]] = count;
    }
    for (std::size_t i = 0; i < tables_.size(); ++i) {
      tables_[i].matrix = {labels_of(stimuli), labels_of(responses), std::move(counts[i])};
    }
    return std::move(tables_);
  }

 private:
  using Numbers = std::vector<std::size_t>;  ///< of labels

  [[nodiscard]] Numbers in_order(Numbers numbers) const {
    if (unit_ == Unit::Word) {
      std::ranges::sort(numbers, {}, [&](std::size_t number) -> const std::string& {
        return labels_.labels()[number];
      });
    } else {
      std::ranges::sort(
          numbers, {}, [&](std::size_t number) { return phones_in(labels_.labels()[number]); });
    }
    return numbers;
  }

  /// The extra ones, which were numbered first, come last.
  [[nodiscard]] Numbers ordered_responses() const {
    const auto extras = extra_responses(unit_).size();
    Numbers own(labels_.labels().size() - extras);
    std::iota(own.begin(), own.end(), extras);
    auto numbers = in_order(std::move(own));
    for (std::size_t number = 0; number < extras; ++number) numbers.push_back(number);
    return numbers;
  }

  /// Where each label is among `numbers`; 0 for those that are not.
  [[nodiscard]] Numbers places_of(const Numbers& numbers) const {
    Numbers places(labels_.labels().size());
    for (std::size_t place = 0; place < numbers.size(); ++place) places[numbers[place]] = place;
    return places;
  }

  [[nodiscard]] std::vector<std::string> labels_of(const Numbers& numbers) const {
    std::vector<std::string> labels;
    for (const auto number : numbers) labels.push_back(labels_.labels()[number]);
    return labels;
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

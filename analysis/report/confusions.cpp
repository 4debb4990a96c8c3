#include "analysis/report/confusions.hpp"

#include <algorithm>
#include <cassert>
#include <set>

namespace bimodal::analysis {

namespace {

using Outcome = UnitScore::Outcome;

std::string_view label(const UnitScore& score) {
  switch (score.outcome) {
    case Outcome::Answered:
      return symbol(score.answer);
    case Outcome::Deleted:
      return kDeleted;
    case Outcome::Blank:
      return kBlank;
    case Outcome::Other:
    case Outcome::Ambiguous:
      break;
  }
  return kOther;
}

const std::optional<UnitScore>& at(const Score& score, Unit unit) {
  return score.units.at(static_cast<std::size_t>(unit));
}

std::vector<std::string> symbols(const std::set<Phone>& phones) {
  std::vector<std::string> labels;
  for (const Phone phone : phones) labels.emplace_back(symbol(phone));
  return labels;
}

ConfusionMatrix empty_matrix(Unit unit, std::span<const Score> scores) {
  std::set<Phone> stimuli;
  std::set<Phone> responses;
  for (const auto& score : scores) {
    const auto& found = at(score, unit);
    if (!found) continue;
    stimuli.insert(found->stimulus);
    if (found->outcome == Outcome::Answered) responses.insert(found->answer);
  }
  responses.insert(stimuli.begin(), stimuli.end());
  auto columns = symbols(responses);
  for (const auto extra : {kDeleted, kBlank, kOther}) columns.emplace_back(extra);
  return {symbols(stimuli), std::move(columns)};
}

}  // namespace

std::vector<UnitConfusions> tabulate_confusions(std::span<const Trial> trials,
                                                std::span<const Score> scores,
                                                std::span<const std::string> conditions) {
  assert(trials.size() == scores.size());
  std::vector<UnitConfusions> tables;
  for (const Unit unit : kUnits) {
    const auto empty = empty_matrix(unit, scores);
    const auto first = tables.size();
    for (const auto& condition : conditions) {
      tables.push_back(
          {.unit = unit, .condition = condition, .matrix = empty, .ambiguous = 0, .lacking = 0});
    }
    for (std::size_t i = 0; i < trials.size(); ++i) {
      const auto condition = std::ranges::find(conditions, trials[i].condition);
      if (condition == conditions.end()) continue;
      auto& table = tables[first + static_cast<std::size_t>(condition - conditions.begin())];
      const auto& found = at(scores[i], unit);
      if (!found) {
        ++table.lacking;
      } else if (found->outcome == Outcome::Ambiguous) {
        ++table.ambiguous;
      } else {
        table.matrix.add(symbol(found->stimulus), label(*found));
      }
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

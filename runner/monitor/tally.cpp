#include "runner/monitor/tally.hpp"

#include <algorithm>
#include <utility>

#include "stimuli/base/lower_case.hpp"

namespace bimodal::runner {

namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

bool is_spelled_as(std::string_view target, std::string_view response) {
  return lower_case(trimmed(target)) == lower_case(trimmed(response));
}

Tally::Tally(const std::vector<std::string>& conditions) {
  for (const auto& condition : conditions) conditions_.push_back({.condition = condition});
}

void Tally::add(TalliedTrial trial) {
  ++stored_;
  flagged_ += trial.flagged ? 1U : 0U;
  if (!trial.is_practice) {
    auto& tally = of(trial.condition);
    ++tally.trials;
    tally.judged += trial.spelled_as_target ? 1U : 0U;
    tally.spelled_as_target += trial.spelled_as_target.value_or(false) ? 1U : 0U;
  }
  latest_.push_back(std::move(trial));
  if (latest_.size() > kLatest) latest_.pop_front();
}

ConditionTally& Tally::of(const std::string& condition) {
  const auto known = std::ranges::find(conditions_, condition, &ConditionTally::condition);
  if (known != conditions_.end()) return *known;
  conditions_.push_back({.condition = condition});
  return conditions_.back();
}

}  // namespace bimodal::runner

#include "analysis/statistics/condition_dealing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace bimodal::analysis {

namespace {

using Label = ConditionDealing::Label;

Label label_of(const ComparedTrial& trial) {
  return trial.other ? Label::Other : Label::One;
}

/// log10 of n! / (k! (n - k)!).
double log10_choices(std::size_t n, std::size_t k) {
  const auto log_factorial = [](std::size_t count) {
    return std::lgamma(static_cast<double>(count) + 1.0);
  };
  return (log_factorial(n) - log_factorial(k) - log_factorial(n - k)) / std::numbers::ln10;
}

/// Neither says One where the other says Other.
bool compatible(const std::vector<Label>& ones, const std::vector<Label>& others) {
  for (std::size_t i = 0; i < ones.size(); ++i) {
    if (ones[i] != Label::Neither && others[i] != Label::Neither && ones[i] != others[i]) {
      return false;
    }
  }
  return true;
}

std::size_t met(const std::vector<Label>& labels) {
  return static_cast<std::size_t>(
      std::ranges::count_if(labels, [](Label label) { return label != Label::Neither; }));
}

std::size_t met_by_both(const std::vector<Label>& ones, const std::vector<Label>& others) {
  std::size_t shared = 0;
  for (std::size_t i = 0; i < ones.size(); ++i) {
    shared += ones[i] != Label::Neither && others[i] != Label::Neither ? 1U : 0U;
  }
  return shared;
}

/// At least nine tenths of what either met, so that a few lost trials do not matter.
bool same_items(const std::vector<Label>& ones, const std::vector<Label>& others) {
  return 10 * met_by_both(ones, others) >= 9 * std::max(met(ones), met(others));
}

}  // namespace

ConditionDealing::ConditionDealing(std::span<const ComparedTrial> trials) {
  for (const auto& trial : trials) {
    observed_.push_back(label_of(trial));
    items_.push_back(trial.item);
  }
  find_groups(trials);
  if (randomisation_ == Randomisation::WithinItems) return;
  find_rolls(trials);
  if (randomisation_ == Randomisation::BetweenParticipants) return;
  find_lists(trials);
}

void ConditionDealing::leave_out_all_but(const std::vector<bool>& used) {
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) observed_[i] = Label::Neither;
  }
}

/// Participant x item with trials in both conditions; the design, if most trials are of such.
void ConditionDealing::find_groups(std::span<const ComparedTrial> trials) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, Group> met;
  for (std::uint32_t i = 0; i < trials.size(); ++i) {
    met[{trials[i].participant, trials[i].item}].push_back(i);
  }
  std::vector<bool> used(trials.size(), false);
  std::size_t exchangeable = 0;
  for (auto& [key, group] : met) {
    const auto others = static_cast<std::size_t>(
        std::ranges::count_if(group, [&](std::uint32_t place) { return trials[place].other; }));
    if (others == 0 || others == group.size()) continue;
    exchangeable += group.size();
    log10_arrangements_ += log10_choices(group.size(), others);
    for (const auto place : group) used[place] = true;
    if (group.size() == 2) {
      const bool swapped = trials[group[0]].other;
      pairs_.push_back({group[swapped ? 1 : 0], group[swapped ? 0 : 1]});
    } else {
      groups_.push_back(std::move(group));
    }
  }
  if (exchangeable == 0 || 2 * exchangeable < trials.size()) {
    pairs_.clear();
    groups_.clear();
    log10_arrangements_ = 0.0;
    return;
  }
  randomisation_ = Randomisation::WithinItems;
  leave_out_all_but(used);
}

/// Whose items had which condition; the design, if all participants met the same items.
void ConditionDealing::find_rolls(std::span<const ComparedTrial> trials) {
  std::size_t items = 0;
  for (const auto& trial : trials) items = std::max<std::size_t>(items, trial.item + 1);
  std::map<std::uint32_t, Roll> by_participant;
  for (std::uint32_t i = 0; i < trials.size(); ++i) {
    auto& roll = by_participant[trials[i].participant];
    roll.labels.resize(items, Label::Neither);
    roll.trials.push_back(i);
    roll.labels[trials[i].item] = label_of(trials[i]);
  }
  for (auto& [participant, roll] : by_participant) rolls_.push_back(std::move(roll));
  if (rolls_.empty()) return;
  merge_versions();
  const auto& first = rolls_.front().labels;
  std::map<std::vector<Label>, std::size_t> versions;
  for (const auto& roll : rolls_) ++versions[roll.labels];
  const bool all_alike =
      std::ranges::all_of(rolls_, [&](const Roll& roll) { return same_items(first, roll.labels); });
  if (!all_alike || versions.size() < 2) return;
  randomisation_ = Randomisation::BetweenParticipants;
  log10_arrangements_ = std::lgamma(static_cast<double>(rolls_.size()) + 1.0) / std::numbers::ln10;
  for (const auto& [labels, count] : versions) {
    log10_arrangements_ -= std::lgamma(static_cast<double>(count) + 1.0) / std::numbers::ln10;
  }
}

/// Participants who had the same lists get the same labels, also of items whose trials are lost.
void ConditionDealing::merge_versions() {
  std::vector<std::pair<std::vector<Label>, std::vector<std::size_t>>> versions;
  for (std::size_t i = 0; i < rolls_.size(); ++i) {
    const auto& labels = rolls_[i].labels;
    const auto version = std::ranges::find_if(versions, [&](const auto& known) {
      return compatible(known.first, labels) && 2 * met_by_both(known.first, labels) > met(labels);
    });
    if (version == versions.end()) {
      versions.push_back({labels, {i}});
      continue;
    }
    version->second.push_back(i);
    for (std::size_t item = 0; item < labels.size(); ++item) {
      if (version->first[item] == Label::Neither) version->first[item] = labels[item];
    }
  }
  for (const auto& [labels, participants] : versions) {
    for (const auto participant : participants) rolls_[participant].labels = labels;
  }
}

/// Items that had the same condition for each version of the design are a list.
void ConditionDealing::find_lists(std::span<const ComparedTrial> trials) {
  std::map<std::vector<Label>, std::vector<std::uint32_t>> items_of_lists;
  const std::size_t items = rolls_.empty() ? 0 : rolls_.front().labels.size();
  for (std::uint32_t item = 0; item < items; ++item) {
    std::vector<Label> column;
    for (const auto& roll : rolls_) column.push_back(roll.labels[item]);
    items_of_lists[column].push_back(item);
  }
  std::vector<bool> used(trials.size(), false);
  for (const auto& [column, members] : items_of_lists) {
    const auto ones = static_cast<std::size_t>(std::ranges::count(column, Label::One));
    const auto others = static_cast<std::size_t>(std::ranges::count(column, Label::Other));
    if (ones == 0 || others == 0) continue;
    log10_arrangements_ += log10_choices(ones + others, ones);
    List list;
    for (std::size_t participant = 0; participant < column.size(); ++participant) {
      if (column[participant] == Label::Neither) continue;
      auto& block = list.trials.emplace_back();
      list.labels.push_back(column[participant]);
      for (const auto place : rolls_[participant].trials) {
        if (std::ranges::find(members, trials[place].item) == members.end()) continue;
        block.push_back(place);
        used[place] = true;
      }
    }
    lists_.push_back(std::move(list));
  }
  rolls_.clear();
  if (!lists_.empty()) randomisation_ = Randomisation::WithinLists;
  leave_out_all_but(used);
}

/// One random bit for each pair.
void ConditionDealing::draw_pairs(Random& random, std::vector<Label>& labels) const {
  constexpr std::size_t kBits = 64;
  for (std::size_t first = 0; first < pairs_.size(); first += kBits) {
    auto bits = random.bits();
    const auto end = std::min(pairs_.size(), first + kBits);
    for (std::size_t i = first; i < end; ++i, bits >>= 1U) {
      const auto bit = static_cast<std::uint8_t>(bits & 1U);
      labels[pairs_[i].one] = static_cast<Label>(bit);
      labels[pairs_[i].other] = static_cast<Label>(1U - bit);
    }
  }
}

void ConditionDealing::draw(Random& random, std::vector<Label>& labels) const {
  labels = observed_;
  draw_pairs(random, labels);
  std::vector<Label> dealt;
  for (const auto& group : groups_) {
    dealt.clear();
    for (const auto place : group) dealt.push_back(observed_[place]);
    shuffle(std::span{dealt}, random);
    for (std::size_t i = 0; i < group.size(); ++i) labels[group[i]] = dealt[i];
  }
  if (randomisation_ == Randomisation::BetweenParticipants) {
    std::vector<std::size_t> donors(rolls_.size());
    for (std::size_t i = 0; i < donors.size(); ++i) donors[i] = i;
    shuffle(std::span{donors}, random);
    for (std::size_t i = 0; i < donors.size(); ++i) {
      for (const auto place : rolls_[i].trials) {
        labels[place] = rolls_[donors[i]].labels[items_[place]];
      }
    }
  }
  for (const auto& list : lists_) {
    dealt = list.labels;
    shuffle(std::span{dealt}, random);
    for (std::size_t i = 0; i < dealt.size(); ++i) {
      for (const auto place : list.trials[i]) labels[place] = dealt[i];
    }
  }
}

}  // namespace bimodal::analysis

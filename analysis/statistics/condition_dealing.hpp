#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/statistics/condition_permutation.hpp"

namespace bimodal::analysis {

/// How the conditions of trials may be dealt again.
class ConditionDealing {
 public:
  /// Which of the two conditions a trial is in, or that it is left out.
  enum class Label : std::uint8_t { One, Other, Neither };

  /// Finds out from the trials what the design randomised.
  explicit ConditionDealing(std::span<const ComparedTrial> trials);

  [[nodiscard]] Randomisation randomisation() const { return randomisation_; }

  /// As they were in the experiment; Neither for trials that cannot be exchanged.
  [[nodiscard]] const std::vector<Label>& observed() const { return observed_; }

  [[nodiscard]] double log10_arrangements() const { return log10_arrangements_; }

  /// Deals the conditions again.
  void draw(Random& random, std::vector<Label>& labels) const;

 private:
  /// Two trials, the first of them in the one condition, the second in the other.
  struct Pair {
    std::uint32_t one;
    std::uint32_t other;
  };

  /// More trials among which labels are exchanged one by one.
  using Group = std::vector<std::uint32_t>;

  /// What one participant met: places of the trials by item.
  struct Roll {
    std::vector<std::uint32_t> trials;
    std::vector<Label> labels;  ///< of every item; Neither: not met
  };

  /// The trials of one list, participant by participant, and the label of each.
  struct List {
    std::vector<std::vector<std::uint32_t>> trials;
    std::vector<Label> labels;
  };

  void draw_pairs(Random& random, std::vector<Label>& labels) const;
  void find_groups(std::span<const ComparedTrial> trials);
  void find_rolls(std::span<const ComparedTrial> trials);
  void merge_versions();
  void find_lists(std::span<const ComparedTrial> trials);
  void leave_out_all_but(const std::vector<bool>& used);

  Randomisation randomisation_ = Randomisation::None;
  std::vector<Label> observed_;
  std::vector<std::uint32_t> items_;  ///< of the trials
  std::vector<Pair> pairs_;           ///< what most groups are, for speed
  std::vector<Group> groups_;
  std::vector<Roll> rolls_;
  std::vector<List> lists_;
  double log10_arrangements_ = 0.0;
};

}  // namespace bimodal::analysis

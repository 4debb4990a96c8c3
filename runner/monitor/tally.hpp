#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bimodal::runner {

/// Whether a response is the target as it is spelled, whatever the case (A to Z) and the blanks
/// around it. Homophones and misspellings are judged by the analysis, not here.
[[nodiscard]] bool is_spelled_as(std::string_view target, std::string_view response);

/// One answered trial, as the experimenter sees it.
struct TalliedTrial {
  std::size_t trial = 0;  ///< from 0
  bool is_practice = false;
  std::string condition;
  std::string word;
  std::string response;                   ///< empty: an omission
  std::optional<bool> spelled_as_target;  ///< absent: there is no one target to be spelled
  bool flagged = false;
};

/// The main trials of one condition.
struct ConditionTally {
  std::string condition;
  std::size_t trials = 0;
  std::size_t judged = 0;             ///< of these, with one target
  std::size_t spelled_as_target = 0;  ///< of the judged
};

/// What a session's answers come to so far. Pure.
class Tally {
 public:
  static constexpr std::size_t kLatest = 8;

  Tally() = default;

  /// Conditions in the order in which they are to be listed; others follow as they come.
  explicit Tally(const std::vector<std::string>& conditions);

  void add(TalliedTrial trial);

  [[nodiscard]] std::size_t stored() const { return stored_; }

  [[nodiscard]] std::size_t flagged() const { return flagged_; }

  [[nodiscard]] const std::vector<ConditionTally>& conditions() const { return conditions_; }

  /// The last kLatest trials, oldest first.
  [[nodiscard]] const std::deque<TalliedTrial>& latest() const { return latest_; }

 private:
  ConditionTally& of(const std::string& condition);

  std::size_t stored_ = 0;
  std::size_t flagged_ = 0;
  std::vector<ConditionTally> conditions_;
  std::deque<TalliedTrial> latest_;
};

}  // namespace bimodal::runner

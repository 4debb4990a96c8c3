#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>

#include "protocols/design/plan.hpp"
#include "protocols/model/timing.hpp"

namespace bimodal::runner {

/// A trial that is presented again.
struct Repetition {
  std::size_t number = 0;    ///< of the new trial
  std::size_t original = 0;  ///< number of the planned trial: of a repetition that of its original
};

/// Decides which trials of a block are presented again at its end: those whose timing was not as
/// planned, in the order in which they took place, practice left out. A repetition that is flagged
/// in its turn goes to the end again, until its original has been repeated as often as the rule
/// allows. Pure.
class Repetitions {
 public:
  /// New trials are numbered from `first_number` on, the number of trials in the plan.
  Repetitions(const protocols::Timing& rule, std::size_t first_number)
      : rule_{rule}, first_number_{first_number} {}

  /// A trial took place: of the plan, or a repetition of it (then `original` is the planned one).
  /// Returns whether it is scheduled to be presented again.
  bool note(const protocols::PlannedTrial& original, bool flagged);

  /// The next repetition of this block, until finish() the same one; absent: there is none (left).
  [[nodiscard]] std::optional<Repetition> next() const;

  /// The next repetition has taken place.
  void finish();

  /// Whether any is still to take place.
  [[nodiscard]] bool pending() const { return !waiting_.empty(); }

  /// How many there have been and are to be, in all blocks so far.
  [[nodiscard]] std::size_t scheduled() const { return finished_ + waiting_.size(); }

 private:
  protocols::Timing rule_;
  std::size_t first_number_;
  std::size_t finished_ = 0;
  std::deque<std::size_t> waiting_;         ///< originals
  std::map<std::size_t, int> repetitions_;  ///< scheduled so far, by original
};

}  // namespace bimodal::runner

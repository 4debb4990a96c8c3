#include "runner/session/repetitions.hpp"

#include <cassert>

namespace bimodal::runner {

bool Repetitions::note(const protocols::PlannedTrial& original, bool flagged) {
  if (!flagged || rule_.flagged != protocols::Flagged::Repeat) return false;
  if (original.phase == protocols::Phase::Practice) return false;
  auto& scheduled = repetitions_[original.index];
  if (scheduled >= rule_.most_repeats) return false;
  ++scheduled;
  waiting_.push_back(original.index);
  return true;
}

std::optional<Repetition> Repetitions::next() const {
  if (waiting_.empty()) return std::nullopt;
  return Repetition{.number = first_number_ + finished_, .original = waiting_.front()};
}

void Repetitions::finish() {
  assert(pending());
  waiting_.pop_front();
  ++finished_;
}

}  // namespace bimodal::runner

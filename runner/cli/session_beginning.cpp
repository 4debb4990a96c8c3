#include "runner/cli/session_beginning.hpp"

#include <utility>

#include <fmt/format.h>

namespace bimodal::runner {

namespace {

/// By what a session goes on: it may have been another machine before.
std::string resumed_text(const SessionRecord& record) {
  return fmt::format("by a new process of version {}, {}; screen: {} ({}); sound: {}",
                     record.program_version,
                     record.started_utc,
                     record.display.description,
                     record.timing ? record.timing->verdict : "not judged",
                     record.audio.description);
}

/// The first of the plan that is not stored.
int next_trial_of(const Beginning& beginning) {
  const auto& done = beginning.resumption->done;
  for (std::size_t i = 0; i < beginning.plan.size(); ++i) {
    if (!done.contains(i)) return beginning.plan[i].trial;
  }
  return static_cast<int>(beginning.plan.size());
}

}  // namespace

std::int64_t begin_in(SessionStore& store, const Beginning& beginning) {
  const auto note = [&](std::int64_t id, const char* kind, std::string detail) {
    store.add(id, EventRecord{beginning.at.time_since_epoch(), kind, std::move(detail)});
  };
  if (beginning.resumption) {
    const auto id = beginning.resumption->session;
    store.reopen(id);
    note(id,
         "resumed",
         fmt::format(
             "from trial {} on, which may have been presented before, cut off and not stored; {}",
             next_trial_of(beginning),
             resumed_text(beginning.record)));
    if (beginning.drops_repetitions) {
      note(id,
           "repetitions_dropped",
           fmt::format("flagged before the session was cut off, and not presented again: trials {}",
                       fmt::join(beginning.resumption->owed, ", ")));
    }
    return id;
  }
  const auto id = store.begin(beginning.record, beginning.plan);
  if (beginning.is_shortened) {
    const auto trials = beginning.plan.size();
    note(id, "shortened", fmt::format("{} trials by --trials or --no-practice", trials));
  }
  if (!beginning.left_out.empty()) {
    note(id, "no_triggers", beginning.left_out + " left out by --no-triggers");
  }
  return id;
}

}  // namespace bimodal::runner

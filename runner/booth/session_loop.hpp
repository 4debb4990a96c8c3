#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/design/plan.hpp"
#include "protocols/model/protocol.hpp"
#include "runner/booth/booth.hpp"
#include "runner/booth/overseer.hpp"
#include "runner/preparation/trial_source.hpp"
#include "runner/store/store_writer.hpp"

namespace bimodal::runner {

/// How a session ended.
struct SessionOutcome {
  std::optional<std::int64_t> session;  ///< the store's number; absent if it ended before any trial
  bool complete = false;                ///< false: stopped by the experimenter
  int trials = 0;                       ///< of the plan, stored
  int repeated = 0;                     ///< stored beside them: trials that were presented again
  int flagged = 0;                      ///< of all these, with timing other than planned
  std::vector<Duration> storing{};  ///< of each answer: from its last stroke until it was on disk
};

/// What the loop borrows.
struct SessionParts {
  const protocols::Protocol& protocol;
  const std::vector<protocols::PlannedTrial>& plan;
  Booth booth;
  TrialSource& trials;
  StoreWriter& store;

  /// Stores the session and its plan, once the display has been watched long enough to state its
  /// refresh; returns the store's number of the session. Called once, before the first trial.
  std::function<std::int64_t(const RefreshEstimate&)> begin;

  /// What is stored of a planned trial; asked for where one is repeated.
  std::function<PlanRecord(const protocols::PlannedTrial&)> plan_record;

  /// The trials (indices into the plan) that an earlier part of this session has stored; `trials`
  /// gives the others only.
  std::set<std::size_t> done{};

  /// The number of the first trial that repeats another: an earlier part of this session may have
  /// had some. Meant if it is above the number of trials in the plan.
  std::size_t first_repetition = 0;

  /// The answer of a simulated participant; empty function: a person answers.
  std::function<std::string(const protocols::PlannedTrial&)> answer;

  /// Whether the experimenter has asked from outside to stop (Ctrl-C): done after the present
  /// stimulus, without asking.
  std::function<bool()> interrupted = [] { return false; };

  /// Told between stimuli what happens, for the experimenter's console.
  std::function<void(std::string_view)> announce = [](std::string_view) {};

  /// Who watches from outside, and may ask to pause, resume and stop; null: nobody.
  Overseer* overseer = nullptr;
};

/// Runs one session from the first page to the last: `run` and `rehearse` differ only in the parts
/// they put in. Every trial is committed before the next begins. Throws StoreError if data cannot
/// be kept (the participant then sees a neutral screen), Error if a trial cannot be prepared.
[[nodiscard]] SessionOutcome run_session(const SessionParts& parts);

}  // namespace bimodal::runner

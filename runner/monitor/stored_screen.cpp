#include <algorithm>

#include <fmt/format.h>

#include "runner/monitor/monitor_screen.hpp"
#include "runner/monitor/screen_text.hpp"
#include "stimuli/base/counted.hpp"

namespace bimodal::runner {

namespace {

/// Dubbed and ambiguous words have no one target to be spelled.
std::optional<bool> judged(const StoredTrial& stored) {
  if (stored.plan.visual_word || stored.plan.articulation) return std::nullopt;
  return is_spelled_as(stored.plan.word, stored.trial.response.text);
}

Tally tally_of(const StoredSession& session) {
  Tally tally;
  for (const auto& stored : session.trials) {
    tally.add({.trial = static_cast<std::size_t>(stored.plan.trial),
               .is_practice = stored.plan.phase == "practice",
               .condition = stored.plan.condition,
               .word = stored.plan.word,
               .response = stored.trial.response.text,
               .spelled_as_target = judged(stored),
               .flagged = stored.trial.flagged});
  }
  return tally;
}

}  // namespace

std::vector<std::string> stored_screen(const std::vector<StoredSession>& sessions) {
  std::vector<std::string> rows;
  for (const auto& stored : sessions) {
    const auto& session = stored.session;
    const auto tally = tally_of(stored);
    rows.push_back(fmt::format("{}   {}   session {}   {}   {}: {} of {}, {} flagged{}",
                               harmless(session.participant),
                               harmless(session.protocol_title),
                               session.session_number,
                               session.started_utc,
                               stored.outcome.empty() ? "interrupted" : stored.outcome,
                               stored.trials.size(),
                               counted(static_cast<std::size_t>(stored.planned_trials), "trial"),
                               tally.flagged(),
                               session.simulated_answers ? ", simulated answers" : ""));
    for (const auto& row : condition_table(tally.conditions(), tally.conditions().size() + 1)) {
      rows.push_back("  " + row);
    }
  }
  return rows;
}

}  // namespace bimodal::runner

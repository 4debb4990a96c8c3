#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runner/monitor/remaining_time.hpp"
#include "runner/monitor/tally.hpp"
#include "runner/session/progress.hpp"

namespace bimodal::runner {

/// What stays the same through a session.
struct SessionDescription {
  std::string participant;
  int session_number = 1;
  std::string title;        ///< of the protocol
  std::string data;         ///< the file
  std::string started_utc;  ///< ISO 8601
  std::size_t trials = 0;   ///< planned
  int blocks = 0;
  std::vector<std::string> conditions;  ///< names, in the protocol's order
  std::string display;
  std::string audio;
  std::optional<std::string> verdict;  ///< on timing: "good", ...; absent: not judged
  bool simulated_answers = false;
  std::size_t stored_before = 0;   ///< trials, if the session was cut off and goes on
  std::size_t flagged_before = 0;  ///< of these
};

/// A line for whoever watches.
struct StatusLine {
  std::string kind;
  std::string text;  ///< one JSON object; README.md in this folder has its keys
};

/// Writes down what a session tells, as lines of JSON. Keeps what lines need of the past. Pure.
class SessionChronicle {
 public:
  explicit SessionChronicle(SessionDescription description);

  [[nodiscard]] StatusLine description_line(Instant at) const;

  /// The verdict on timing has been found.
  void judge(std::string verdict) { description_.verdict = std::move(verdict); }

  [[nodiscard]] std::vector<StatusLine> on(const Progress& progress);

 private:
  using Lines = std::vector<StatusLine>;

  [[nodiscard]] Lines on_page(const PageShown& page) const;
  [[nodiscard]] Lines on_trial(const TrialReached& reached);
  [[nodiscard]] Lines on_result(const TrialResult& result);
  [[nodiscard]] Lines on_pause(const PauseChanged& pause);

  /// Trials of the whole session.
  [[nodiscard]] std::size_t stored() const { return description_.stored_before + tally_.stored(); }

  [[nodiscard]] std::size_t flagged() const {
    return description_.flagged_before + tally_.flagged();
  }

  [[nodiscard]] StatusLine tally_line(Instant at) const;
  [[nodiscard]] StatusLine times_line(Instant at) const;
  [[nodiscard]] StatusLine end_line(const SessionEnded& ended) const;
  [[nodiscard]] const std::string& condition_of(const protocols::PlannedTrial& trial) const;

  SessionDescription description_;
  Tally tally_;
  RemainingTime remaining_;
  std::size_t of_;                      ///< trials of the session
  std::optional<Instant> began_;        ///< first word of the session
  std::optional<Instant> trial_began_;  ///< the present trial
  std::optional<Instant> paused_since_;
  Duration paused_in_trial_{};
};

}  // namespace bimodal::runner

#include "runner/booth/progress_teller.hpp"

#include <utility>

namespace bimodal::runner {

void ProgressTeller::page(const std::string& text, bool is_break) {
  oversight_.tell(PageShown{booth_.clock.now(), text, is_break});
}

void ProgressTeller::reached(const protocols::PlannedTrial& trial,
                             std::size_t of,
                             TrialState state) {
  oversight_.tell(TrialReached{booth_.clock.now(), trial, of, state});
}

void ProgressTeller::answered(const protocols::PlannedTrial& trial,
                              const TrialRecord& record,
                              std::int64_t underflows) {
  health_.add(record, booth_.display.refresh().period, underflows);
  TrialResult result{.at = {},
                     .trial = trial,
                     .response = record.response.text,
                     .timed_out = record.response.timed_out,
                     .flagged = record.flagged,
                     .events = {}};
  for (const auto& event : record.events) result.events.emplace_back(event.kind, event.detail);
  answered_.emplace(std::move(result));
}

void ProgressTeller::stored(std::size_t of) {
  if (!answered_) return;
  reached(answered_->trial, of, TrialState::Stored);
  answered_->at = booth_.clock.now();
  oversight_.tell(*answered_);
  answered_.reset();
  tell_health();
}

void ProgressTeller::ended(std::string_view outcome) {
  oversight_.tell(SessionEnded{booth_.clock.now(), std::string{outcome}, ""});
}

void ProgressTeller::failed(const std::string& why) {
  if (booth_.audio.playback().lost) health_.note_lost_sound();
  tell_health();
  oversight_.tell(SessionEnded{booth_.clock.now(), "failed", why});
}

void ProgressTeller::tell_health() {
  oversight_.tell(health_.at(booth_.clock.now(), booth_.display.refresh()));
}

}  // namespace bimodal::runner

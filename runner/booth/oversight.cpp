#include "runner/booth/oversight.hpp"

namespace bimodal::runner {

namespace {

constexpr const char* kByExperimenter = "asked for by the experimenter";

/// Requests taken at a time: whoever sends them faster than refreshes come delays no picture.
constexpr int kMostAtOnce = 8;

}  // namespace

void Oversight::tell(const Progress& progress) {
  if (overseer_ != nullptr) overseer_->tell(progress);
}

bool Oversight::stop_asked() {
  for (int i = 0; overseer_ != nullptr && i < kMostAtOnce; ++i) {
    const auto request = overseer_->request();
    if (!request) break;
    take(*request);
  }
  return stop_asked_ || interrupted_();
}

void Oversight::take(Request request) {
  switch (request) {
    case Request::Pause:
      if (!pause_asked_ || !by_experimenter_) note_wish(kByExperimenter, true);
      break;
    case Request::Resume:
      pause_asked_ = false;
      if (!paused_) tell_pause(PauseChanged::State::Running);
      break;
    case Request::Stop:
      stop_asked_ = true;
      break;
  }
}

void Oversight::ask_for_pause(const std::string& reason) {
  if (!pause_asked_) note_wish(reason, false);
}

void Oversight::note_wish(const std::string& reason, bool by_experimenter) {
  pause_asked_ = true;
  by_experimenter_ = by_experimenter;
  reason_ = reason;
  tell_pause(paused_ ? PauseChanged::State::Paused : PauseChanged::State::Asked);
}

void Oversight::note_pause() {
  paused_ = true;
  tell_pause(PauseChanged::State::Paused);
}

void Oversight::note_resumption() {
  paused_ = false;
  tell_pause(PauseChanged::State::Running);
}

void Oversight::tell_pause(PauseChanged::State state) {
  tell(PauseChanged{.at = clock_.now(),
                    .state = state,
                    .reason = state == PauseChanged::State::Running ? "" : reason_});
}

}  // namespace bimodal::runner

#pragma once

#include <functional>
#include <string>

#include "runner/booth/overseer.hpp"
#include "runner/devices/clock.hpp"

namespace bimodal::runner {

/// What has been asked of the session from outside, and by what ear it is told: the session's side
/// of an Overseer. Nothing here is called while a stimulus is on. For the session's thread.
class Oversight {
 public:
  /// `overseer`: null if nobody watches. `interrupted`: as in SessionParts. All borrowed.
  Oversight(Overseer* overseer, const std::function<bool()>& interrupted, const Clock& clock)
      : overseer_{overseer}, interrupted_{interrupted}, clock_{clock} {}

  void tell(const Progress& progress);

  /// Takes what has been asked for; whether the session is to be stopped.
  [[nodiscard]] bool stop_asked();

  /// Whether it is to be paused, or stay so. By what stop_asked() has taken.
  [[nodiscard]] bool pause_asked() const { return pause_asked_; }

  /// A pause of the session's own; it stays until somebody resumes.
  void ask_for_pause(const std::string& reason);

  /// Why the pause was asked for.
  [[nodiscard]] const std::string& reason() const { return reason_; }

  /// The pause has begun, or is over.
  void note_pause();
  void note_resumption();

 private:
  void take(Request request);
  void tell_pause(PauseChanged::State state);

  Overseer* overseer_;
  const std::function<bool()>& interrupted_;
  const Clock& clock_;
  bool stop_asked_ = false;
  bool pause_asked_ = false;
  bool paused_ = false;
  std::string reason_;
};

}  // namespace bimodal::runner

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

  /// A pause of the session's own, because something went wrong at the participant's place; it
  /// stays until somebody resumes, there or from outside.
  void ask_for_pause(const std::string& reason);

  /// Whether the present pause may be ended where the participant sits. One that the experimenter
  /// asked for may not.
  [[nodiscard]] bool resumes_on_the_spot() const { return pause_asked_ && !by_experimenter_; }

  /// Somebody there has ended it.
  void resume() { pause_asked_ = false; }

  /// Why the pause was asked for.
  [[nodiscard]] const std::string& reason() const { return reason_; }

  /// The pause has begun, or is over.
  void note_pause();
  void note_resumption();

 private:
  void take(Request request);
  void note_wish(const std::string& reason, bool by_experimenter);
  void tell_pause(PauseChanged::State state);

  Overseer* overseer_;
  const std::function<bool()>& interrupted_;
  const Clock& clock_;
  bool stop_asked_ = false;
  bool pause_asked_ = false;
  bool by_experimenter_ = false;
  bool paused_ = false;
  std::string reason_;
};

}  // namespace bimodal::runner

#include "runner/booth/session_loop.hpp"

#include <algorithm>
#include <exception>
#include <future>
#include <utility>

#include <fmt/format.h>

#include "runner/booth/participant_screens.hpp"
#include "runner/booth/pause.hpp"
#include "runner/booth/progress_teller.hpp"
#include "runner/booth/stop_question.hpp"
#include "runner/booth/trial_presentation.hpp"
#include "runner/devices/device_error.hpp"
#include "runner/session/session_steps.hpp"
#include "runner/session/trial_machine.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

/// Before the first trial the display must have been watched for this many refreshes.
constexpr int kRefreshesWatched = 100;

/// But no longer than this, for a display may stop telling.
constexpr int kMostWatched = 300;

/// How long to wait for the word of the lines to other equipment on what became of signals.
constexpr Duration kTriggerPatience = std::chrono::milliseconds{300};

Duration since_zero(Instant at) {
  return at.time_since_epoch();
}

KeystrokeRecord record_of(const Keystroke& stroke) {
  KeystrokeRecord record{.at = since_zero(stroke.at),
                         .source = std::string{stroke.source},
                         .key = label(stroke),
                         .uncertainty = stroke.uncertainty};
  if (stroke.key == Key::Pointer) {
    record.x = stroke.x;
    record.y = stroke.y;
  }
  return record;
}

class SessionLoop {
 public:
  explicit SessionLoop(const SessionParts& parts)
      : parts_{parts},
        booth_{parts.booth},
        triggers_{parts.protocol.triggers, parts.booth.trigger_lines},
        oversight_{parts.overseer, parts.interrupted, parts.booth.clock} {}

  SessionOutcome run() {
    const auto steps = session_steps(parts_.protocol, parts_.plan);
    for (const auto& step : steps_left(steps, parts_.done, "We go on where we stopped.")) {
      const bool go_on = std::holds_alternative<PageStep>(step)
                             ? show_page(std::get<PageStep>(step))
                             : run_trial(std::get<TrialStep>(step));
      if (!go_on) break;
    }
    outcome_.complete =
        parts_.done.size() + static_cast<std::size_t>(outcome_.trials) == parts_.plan.size();
    teller_.ended(outcome_.complete ? "complete" : "stopped");
    return outcome_;
  }

  /// The session ends because of an error.
  void fail(const std::string& why) {
    try {
      present({});
    } catch (const DeviceError&) {
      // It is the screen that failed.
    }
    teller_.failed(why);
  }

 private:
  void present(const Screen& screen) {
    static_cast<void>(booth_.display.present(screen, booth_.clock.now()));
  }

  /// False if the session is to be stopped.
  bool show_page(const PageStep& page) {
    Screen screen = page_screen(page.text);
    if (page.is_break) {
      screen.progress = page.progress;
      parts_.announce("break");
      store_event("break", "");
    }
    const auto question = stop_question();
    bool confirming = false;
    begin_page(page);
    while (true) {
      if (oversight_.stop_asked()) return false;
      if (oversight_.pause_asked()) {
        if (!pause()) return false;
        begin_page(page);
      }
      present(confirming ? question : screen);
      for (const auto& stroke : booth_.keyboard.poll()) {
        const bool stop = asks_to_stop(stroke);
        if (stop && confirming) return false;
        if (stroke.key == Key::Enter && !confirming) return true;
        if (stop || stroke.key == Key::Enter) confirming = stop;
      }
    }
  }

  void begin_page(const PageStep& page) {
    teller_.page(page.text, page.is_break);
    if (parts_.answer) booth_.keyboard.expect("", booth_.clock.now());
  }

  bool run_trial(const TrialStep& step) {
    const auto& planned = parts_.plan.at(step.trial);
    if (!take_requests()) return false;
    tell_state(planned, TrialState::Preparing);
    if (!await_preparation(step.progress)) return false;
    const PreparedTrial trial = parts_.trials.next();
    begin_once();  // after preparing: of a session that cannot be prepared nothing is stored
    TrialRecord record;
    record.trial = static_cast<int>(planned.index);
    record.sound = trial.sound_record;
    record.recordings = trial.recordings;
    TrialMachine machine{
        {.fixation = parts_.protocol.intervals.fixation,
         .time_limit = parts_.protocol.response.time_limit,
         .longest_answer = static_cast<std::size_t>(parts_.protocol.response.longest)}};
    parts_.announce(fmt::format("trial {} of {}: {}",
                                planned.index + 1,
                                parts_.plan.size(),
                                parts_.protocol.conditions.at(planned.condition).name));
    triggers_.begin(record.trial, parts_.protocol.conditions.at(planned.condition).name);
    tell_state(planned, TrialState::Fixation);
    parts_.trials.hold();
    static_cast<void>(present_trial(booth_, trial, machine, triggers_, record, [&] {
      tell_state(planned, TrialState::Presenting);
    }));
    parts_.trials.release();
    tell_state(planned, TrialState::Responding);
    const auto underflows = trial.sound ? booth_.audio.playback().underflows : 0;
    if (parts_.answer) booth_.keyboard.expect(parts_.answer(planned), booth_.clock.now());
    const bool go_on = collect_answer(machine, step.progress, record);
    if (!go_on) {
      store_event("stopped", fmt::format("in trial {}, presented but not answered", planned.index));
      return false;
    }
    finish_triggers(record);
    ++outcome_.trials;
    outcome_.flagged += record.flagged ? 1 : 0;
    teller_.answered(planned, record, underflows);
    if (std::ranges::find(record.events, "screen_silent", &EventRecord::kind) !=
        record.events.end()) {
      oversight_.ask_for_pause(
          "the screen reports nothing: it may be asleep, or its window hidden");
    }
    const bool stays = pause_until_stored(parts_.store.add(*outcome_.session, std::move(record)));
    teller_.stored(parts_.plan.size());
    return stays;
  }

  /// False if the session is to be stopped; the unfinished trial is then not stored.
  bool collect_answer(TrialMachine& machine, double progress, TrialRecord& record) {
    while (true) {
      if (oversight_.stop_asked()) return false;
      show_answer(machine, progress);
      for (const auto& stroke : booth_.keyboard.poll()) {
        if (machine.phase() == TrialMachine::Phase::Responding) {
          record.keystrokes.push_back(record_of(stroke));
        }
        for (const auto& command : machine.on(stroke)) {
          if (std::holds_alternative<StopSession>(command)) return false;
          if (take_response(command, record)) return true;
        }
      }
      for (const auto& command : machine.on(Tick{booth_.clock.now()})) {
        if (take_response(command, record)) return true;
      }
    }
  }

  void show_answer(const TrialMachine& machine, double progress) {
    const bool confirming = machine.phase() == TrialMachine::Phase::Confirming;
    auto screen = confirming ? stop_question()
                             : answer_screen(parts_.protocol.response.prompt, machine.answer());
    screen.progress = progress;
    present(screen);
  }

  /// Tells of the answer; the blank that follows it has begun when all lines have reported.
  void finish_triggers(TrialRecord& record) {
    if (!record.response.timed_out) {
      triggers_.send(protocols::TriggerEvent::Response, Instant{record.response.submitted});
    }
    const auto latest = booth_.clock.now() + kTriggerPatience;
    while (!triggers_.settled() && booth_.clock.now() < latest) present({});
    triggers_.finish(record, booth_.clock.now());
  }

  static bool take_response(const TrialCommand& command, TrialRecord& record) {
    const auto* const response = std::get_if<RecordResponse>(&command);
    if (response == nullptr) return false;
    record.response = {.text = response->text,
                       .submitted = since_zero(response->submitted),
                       .timed_out = response->timed_out};
    if (response->first_key) record.response.first_key = since_zero(*response->first_key);
    return true;
  }

  /// The blank between trials, at least until the data are on the disk. False if the session is to
  /// be stopped.
  bool pause_until_stored(std::future<void> stored) {
    const auto end = booth_.clock.now() + parts_.protocol.intervals.pause;
    bool stop = false;
    while (!stop && booth_.clock.now() < end) {
      present({});
      stop = stop_is_meant(booth_, oversight_);
    }
    stored.get();
    if (stop) store_event("stopped", "between trials");
    return !stop;
  }

  void discard_keystrokes() { static_cast<void>(booth_.keyboard.poll()); }

  void begin_once() {
    if (outcome_.session) return;
    const bool measures = booth_.display.time_source() != TimeSource::Predicted;
    for (int more = 0; measures && more < kMostWatched; ++more) {
      if (booth_.display.refresh().count >= kRefreshesWatched || oversight_.stop_asked()) break;
      present({});
      discard_keystrokes();
    }
    outcome_.session = parts_.begin(booth_.display.refresh());
  }

  void store_event(std::string kind, std::string detail) {
    if (!outcome_.session) return;  // before the first trial nothing is stored
    parts_.store
        .add(*outcome_.session,
             EventRecord{.at = since_zero(booth_.clock.now()),
                         .kind = std::move(kind),
                         .detail = std::move(detail)})
        .get();
  }

  /// False if the session is to be stopped.
  bool await_preparation(double progress) {
    auto waiting = waiting_screen();
    waiting.progress = progress;
    while (!parts_.trials.ready()) {
      if (!take_requests() || stop_is_meant(booth_, oversight_)) return false;
      present(waiting);
    }
    return true;
  }

  /// Between trials. False if the session is to be stopped.
  bool take_requests() {
    if (oversight_.stop_asked()) {
      store_event("stopped", "between trials, as asked from outside");
      return false;
    }
    return !oversight_.pause_asked() || pause();
  }

  /// False if the session is to be stopped.
  bool pause() {
    store_event("paused", oversight_.reason());
    parts_.announce("paused: " + oversight_.reason());
    const auto end = hold_pause(booth_, oversight_);
    const bool resumed = end == PauseEnd::Resumed;
    parts_.announce(resumed ? "resumed" : "stopped");
    store_event(resumed ? "resumed" : "stopped", resumed ? "" : "during a pause");
    return resumed;
  }

  void tell_state(const protocols::PlannedTrial& trial, TrialState state) {
    teller_.reached(trial, parts_.plan.size(), state);
  }

  const SessionParts& parts_;
  const Booth& booth_;
  TriggerLog triggers_;
  Oversight oversight_;
  ProgressTeller teller_{booth_, oversight_};
  SessionOutcome outcome_;
};

}  // namespace

SessionOutcome run_session(const SessionParts& parts) {
  SessionLoop loop{parts};
  try {
    return loop.run();
  } catch (const std::exception& error) {
    loop.fail(describe(error));
    throw;
  }
}

}  // namespace bimodal::runner

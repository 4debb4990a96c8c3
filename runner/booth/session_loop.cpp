#include "runner/booth/session_loop.hpp"

#include <algorithm>
#include <exception>
#include <future>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "runner/booth/answering.hpp"
#include "runner/booth/participant_screens.hpp"
#include "runner/booth/pause.hpp"
#include "runner/booth/progress_teller.hpp"
#include "runner/booth/refresh_watch.hpp"
#include "runner/booth/stimulus_presentation.hpp"
#include "runner/booth/stop_question.hpp"
#include "runner/booth/trial_presentation.hpp"
#include "runner/devices/device_error.hpp"
#include "runner/session/repetitions.hpp"
#include "runner/session/session_steps.hpp"
#include "runner/session/trial_machine.hpp"
#include "stimuli/base/error.hpp"

namespace bimodal::runner {

namespace {

Duration since_zero(Instant at) {
  return at.time_since_epoch();
}

class SessionLoop {
 public:
  explicit SessionLoop(const SessionParts& parts)
      : parts_{parts},
        booth_{parts.booth},
        triggers_{parts.protocol.triggers, parts.booth.trigger_lines},
        oversight_{parts.overseer, parts.interrupted, parts.booth.clock},
        repetitions_{parts.protocol.timing, first_repetition(parts)} {}

  SessionOutcome run() {
    const auto steps = session_steps(parts_.protocol, parts_.plan);
    const auto left = steps_left(steps, parts_.done, "We go on where we stopped.");
    const bool stopped =
        !std::ranges::all_of(left, [this](const SessionStep& step) { return take(step); });
    if (!stopped) static_cast<void>(repeat_flagged());
    const auto stored = parts_.done.size() + static_cast<std::size_t>(outcome_.trials);
    outcome_.complete = stored == parts_.plan.size() && !repetitions_.pending();
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

  /// False if the session is to be stopped. A block is over when a page comes.
  bool take(const SessionStep& step) {
    if (const auto* const page = std::get_if<PageStep>(&step)) {
      return repeat_flagged() && show_page(*page);
    }
    return run_trial(std::get<TrialStep>(step));
  }

  bool run_trial(const TrialStep& step) {
    const auto& planned = parts_.plan.at(step.trial);
    if (!take_requests()) return false;
    tell_state(planned, TrialState::Preparing);
    if (!await_preparation(step.progress)) return false;
    auto trial = parts_.trials.next();
    begin_once();  // after preparing: of a session that cannot be prepared nothing is stored
    progress_ = step.progress;
    parts_.announce(fmt::format(
        "trial {} of {}: {}", planned.index + 1, parts_.plan.size(), condition_of(planned)));
    const auto end = carry_out(planned, trial);
    outcome_.trials += end.stored ? 1 : 0;
    if (end.stored && repetitions_.note(planned, end.flagged)) {
      kept_.emplace(planned.index, std::move(trial));
    }
    return end.goes_on;
  }

  /// At the end of a block: presents again what the protocol wants to be. False if the session is
  /// to be stopped.
  bool repeat_flagged() {
    while (const auto repetition = repetitions_.next()) {
      if (!take_requests() || !repeat(*repetition)) return false;
    }
    kept_.clear();
    return true;
  }

  bool repeat(const Repetition& repetition) {
    const auto& original = parts_.plan.at(repetition.original);
    auto planned = original;
    planned.index = repetition.number;
    auto record = parts_.plan_record(planned);
    record.repeats = static_cast<int>(original.index);
    parts_.store.add(*outcome_.session, std::move(record)).get();
    parts_.announce(fmt::format("trial {} again, its timing was not as planned: {}",
                                original.index + 1,
                                condition_of(planned)));
    const auto end = carry_out(planned, kept_.at(original.index));
    if (!end.stored) return false;
    ++outcome_.repeated;
    repetitions_.finish();
    repetitions_.note(original, end.flagged);
    return end.goes_on;
  }

  /// How a trial ended.
  struct TrialEnd {
    bool stored = false;
    bool flagged = false;
    bool goes_on = false;  ///< false: the session is to be stopped
  };

  TrialEnd carry_out(const protocols::PlannedTrial& planned, const PreparedTrial& trial) {
    TrialRecord record;
    record.trial = static_cast<int>(planned.index);
    record.sound = trial.sound_record;
    record.recordings = trial.recordings;
    TrialMachine machine{trial_rules(parts_.protocol, question_)};
    triggers_.begin(record.trial, condition_of(planned));
    tell_state(planned, TrialState::Fixation);
    parts_.trials.hold();
    const auto at_end = present_trial(booth_, trial, machine, triggers_, record, [&] {
      tell_state(planned, TrialState::Presenting);
    });
    parts_.trials.release();
    tell_state(planned, TrialState::Responding);
    const auto underflows = trial.sound ? booth_.audio.playback().underflows : 0;
    if (parts_.answer) booth_.keyboard.expect(parts_.answer(planned), booth_.clock.now());
    if (!collect_answer(booth_, oversight_, question_, progress_, machine, at_end, record)) {
      store_event("stopped", fmt::format("in trial {}, presented but not answered", planned.index));
      return {};
    }
    finish_triggers(booth_, machine, triggers_, record);
    if (trial.sound) review_sound(booth_, record);
    record.excluded = record.flagged && parts_.protocol.timing.flagged != protocols::Flagged::Keep;
    TrialEnd end{.stored = true, .flagged = record.flagged};
    outcome_.flagged += record.flagged ? 1 : 0;
    teller_.answered(planned, record, underflows);
    announce_flags(record);
    const auto trouble = screen_guard_.trouble(record, booth_.display.refresh());
    if (!trouble.empty()) oversight_.ask_for_pause(trouble);
    const auto since = since_last_stroke(booth_, machine, record);
    auto stored = parts_.store.add(*outcome_.session, std::move(record));
    end.goes_on = pause_until(stored);
    const auto committed = stored.get();
    if (!end.goes_on) store_event("stopped", "between trials");
    if (since) {
      outcome_.storing.push_back(*since + committed);
      teller_.note_storing(outcome_.storing.back());
    }
    teller_.stored(trials_planned());
    return end;
  }

  /// What made the trial other than planned, for whoever runs the session.
  void announce_flags(const TrialRecord& record) {
    if (!record.flagged) return;
    std::string why;
    for (const auto& event : record.events) {
      why += fmt::format("{}{} ({})", why.empty() ? "" : ", ", event.kind, event.detail);
    }
    parts_.announce(fmt::format("trial {} is flagged: {}", record.trial + 1, why));
  }

  /// The blank between trials, at least until the data are on the disk. False if the session is to
  /// be stopped.
  bool pause_until(const std::future<Duration>& stored) {
    constexpr std::chrono::milliseconds kFirst{5};  // drawing would keep the store waiting
    static_cast<void>(stored.wait_for(kFirst));
    const auto end = booth_.clock.now() + parts_.protocol.intervals.pause;
    bool stop = false;
    while (!stop && booth_.clock.now() < end) {
      present({});
      stop = stop_is_meant(booth_, oversight_);
    }
    stored.wait();
    return !stop;
  }

  void begin_once() {
    if (outcome_.session) return;
    watch_refreshes(booth_, oversight_);
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
    if (parts_.answer && oversight_.resumes_on_the_spot()) {
      booth_.keyboard.expect("", booth_.clock.now());
    }
    const auto end = hold_pause(booth_, oversight_);
    const bool resumed = end == PauseEnd::Resumed;
    parts_.announce(resumed ? "resumed" : "stopped");
    store_event(resumed ? "resumed" : "stopped", resumed ? "" : "during a pause");
    return resumed;
  }

  void tell_state(const protocols::PlannedTrial& trial, TrialState state) {
    teller_.reached(trial, trials_planned(), state);
  }

  /// By now, repetitions included.
  [[nodiscard]] std::size_t trials_planned() const {
    return first_repetition(parts_) + repetitions_.scheduled();
  }

  [[nodiscard]] const std::string& condition_of(const protocols::PlannedTrial& trial) const {
    return parts_.protocol.conditions.at(trial.condition).name;
  }

  static std::size_t first_repetition(const SessionParts& parts) {
    return std::max(parts.plan.size(), parts.first_repetition);
  }

  const SessionParts& parts_;
  const Booth& booth_;
  TriggerLog triggers_;
  Oversight oversight_;
  ProgressTeller teller_{booth_, oversight_};
  ScreenGuard screen_guard_;
  Question question_{question_of(parts_.protocol)};
  Repetitions repetitions_;
  std::map<std::size_t, PreparedTrial> kept_;  ///< to be repeated, by the original's index
  double progress_ = 0.0;                      ///< part of the main trials done
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

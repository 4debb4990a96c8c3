#include "runner/booth/session_loop.hpp"

#include <algorithm>
#include <future>
#include <utility>

#include <fmt/format.h>

#include "runner/booth/trial_presentation.hpp"
#include "runner/session/session_steps.hpp"
#include "runner/session/trial_machine.hpp"

namespace bimodal::runner {

namespace {

/// Before the first trial the display must have been watched for this many refreshes.
constexpr int kRefreshesWatched = 100;

/// But no longer than this, for a display may stop telling.
constexpr int kMostWatched = 300;

/// How long to wait for the word of the lines to other equipment on what became of signals.
constexpr Duration kTriggerPatience = std::chrono::milliseconds{300};

constexpr const char* kStopQuestion =
    "Stop the session here?\n\nEscape: stop. What has been answered is kept.\nEnter: go on.";

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
        triggers_{parts.protocol.triggers, parts.booth.trigger_lines} {}

  SessionOutcome run() {
    for (const auto& step : session_steps(parts_.protocol, parts_.plan)) {
      const bool go_on = std::holds_alternative<PageStep>(step)
                             ? show_page(std::get<PageStep>(step))
                             : run_trial(std::get<TrialStep>(step));
      if (!go_on) break;
    }
    outcome_.complete = outcome_.trials == static_cast<int>(parts_.plan.size());
    return outcome_;
  }

  /// What the participant sees while the session ends because of an error.
  void show_neutral() { present({}); }

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
    Screen question;
    question.captions = {{.text = kStopQuestion, .centre_y = 0.45, .size = 0.035}};
    bool confirming = false;
    if (parts_.answer) booth_.keyboard.expect("", booth_.clock.now());
    while (true) {
      if (parts_.interrupted()) return false;
      present(confirming ? question : screen);
      for (const auto& stroke : booth_.keyboard.poll()) {
        const bool stop = asks_to_stop(stroke);
        if (stop && confirming) return false;
        if (stroke.key == Key::Enter && !confirming) return true;
        if (stop || stroke.key == Key::Enter) confirming = stop;
      }
    }
  }

  bool run_trial(const TrialStep& step) {
    const auto& planned = parts_.plan.at(step.trial);
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
    parts_.trials.hold();
    static_cast<void>(present_trial(booth_, trial, machine, triggers_, record));
    parts_.trials.release();
    if (parts_.answer) booth_.keyboard.expect(parts_.answer(planned), booth_.clock.now());
    const bool go_on = collect_answer(machine, step.progress, record);
    if (!go_on) {
      store_event("stopped", fmt::format("in trial {}, presented but not answered", planned.index));
      return false;
    }
    finish_triggers(record);
    ++outcome_.trials;
    outcome_.flagged += record.flagged ? 1 : 0;
    return pause_until_stored(parts_.store.add(*outcome_.session, std::move(record)));
  }

  /// False if the session is to be stopped; the unfinished trial is then not stored.
  bool collect_answer(TrialMachine& machine, double progress, TrialRecord& record) {
    Screen screen;
    screen.progress = progress;
    while (true) {
      if (parts_.interrupted()) return false;
      show_answer(machine, screen);
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

  void show_answer(const TrialMachine& machine, Screen& screen) {
    if (machine.phase() == TrialMachine::Phase::Confirming) {
      screen.captions = {{.text = kStopQuestion, .centre_y = 0.45, .size = 0.035}};
    } else {
      screen.captions = {{.text = parts_.protocol.response.prompt, .centre_y = 0.40, .size = 0.035},
                         {.text = machine.answer() + "_", .centre_y = 0.52, .size = 0.05},
                         {.text = "Enter: next word", .centre_y = 0.86, .size = 0.025}};
    }
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
      stop = stop_is_meant();
    }
    await(std::move(stored));
    if (stop) store_event("stopped", "between trials");
    return !stop;
  }

  /// Where nothing else is typed: whether Escape or the closed window was meant.
  bool stop_is_meant() {
    if (std::ranges::none_of(booth_.keyboard.poll(), asks_to_stop)) return false;
    Screen question;
    question.captions = {{.text = kStopQuestion, .centre_y = 0.45, .size = 0.035}};
    while (true) {
      if (parts_.interrupted()) return true;
      present(question);
      for (const auto& stroke : booth_.keyboard.poll()) {
        if (asks_to_stop(stroke)) return true;
        if (stroke.key == Key::Enter) return false;
      }
    }
  }

  static void await(std::future<void> stored) { stored.get(); }

  void discard_keystrokes() { static_cast<void>(booth_.keyboard.poll()); }

  void begin_once() {
    if (outcome_.session) return;
    const bool measures = booth_.display.time_source() != TimeSource::Predicted;
    for (int more = 0; measures && more < kMostWatched; ++more) {
      if (booth_.display.refresh().count >= kRefreshesWatched || parts_.interrupted()) break;
      present({});
      discard_keystrokes();
    }
    outcome_.session = parts_.begin(booth_.display.refresh());
  }

  void store_event(std::string kind, std::string detail) {
    await(parts_.store.add(*outcome_.session,
                           EventRecord{.at = since_zero(booth_.clock.now()),
                                       .kind = std::move(kind),
                                       .detail = std::move(detail)}));
  }

  /// False if the session is to be stopped.
  bool await_preparation(double progress) {
    Screen waiting;
    waiting.captions = {{.text = "One moment, please ...", .centre_y = 0.45, .size = 0.035}};
    waiting.progress = progress;
    while (!parts_.trials.ready()) {
      if (parts_.interrupted() || stop_is_meant()) return false;
      present(waiting);
    }
    return true;
  }

  const SessionParts& parts_;
  const Booth& booth_;
  TriggerLog triggers_;
  SessionOutcome outcome_;
};

}  // namespace

Screen page_screen(std::string text) {
  Screen screen;
  screen.captions = {{.text = std::move(text), .centre_y = 0.42, .size = 0.035},
                     {.text = "Press Enter to go on.", .centre_y = 0.86, .size = 0.025}};
  return screen;
}

SessionOutcome run_session(const SessionParts& parts) {
  SessionLoop loop{parts};
  try {
    return loop.run();
  } catch (...) {
    loop.show_neutral();
    throw;
  }
}

}  // namespace bimodal::runner

#include "runner/booth/answering.hpp"

#include "runner/booth/keystroke_record.hpp"
#include "runner/booth/participant_screens.hpp"
#include "runner/booth/response_record.hpp"

namespace bimodal::runner {

namespace {

using protocols::ResponseKind;

/// How often keys, and then what became of triggers, are looked for while what is shown stays.
constexpr Duration kPollEvery = std::chrono::microseconds{250};

/// After so long it is shown anew, should the window have lost it.
constexpr Duration kShowAgainAfter = std::chrono::seconds{5};

/// How long to wait for the word of the lines to other equipment on what became of signals.
constexpr Duration kTriggerPatience = std::chrono::milliseconds{300};

enum class Answering { GoesOn, Done, Stopped };

/// The mouse cursor is there as long as something can be clicked.
class ShownPointer {
 public:
  ShownPointer(Keyboard& keyboard, bool shown) : keyboard_{keyboard}, shown_{shown} {
    if (shown_) keyboard_.show_pointer(true);
  }

  ~ShownPointer() {
    if (shown_) keyboard_.show_pointer(false);
  }

  ShownPointer(const ShownPointer&) = delete;
  ShownPointer& operator=(const ShownPointer&) = delete;
  ShownPointer(ShownPointer&&) = delete;
  ShownPointer& operator=(ShownPointer&&) = delete;

 private:
  Keyboard& keyboard_;
  bool shown_;
};

class AnswerLoop {
 public:
  AnswerLoop(const Booth& booth,
             const Question& question,
             double progress,
             TrialMachine& machine,
             TrialRecord& record)
      : booth_{booth},
        question_{question},
        progress_{progress},
        machine_{machine},
        record_{record} {}

  /// One refresh if there is something new to show, or else a quarter of a millisecond: what is
  /// answered is taken at once and need not wait for the screen.
  Answering step() {
    if (!is_shown()) {
      show();
    } else {
      booth_.display.wait(booth_.clock.now() + kPollEvery);
    }
    for (const auto& stroke : booth_.keyboard.poll()) {
      if (machine_.takes_answer()) record_.keystrokes.push_back(record_of(stroke));
      const auto taken = take(machine_.on(stroke));
      if (taken != Answering::GoesOn) return taken;
    }
    return take(machine_.on(Tick{booth_.clock.now()}));
  }

  Answering take(const std::vector<TrialCommand>& commands) {
    for (const auto& command : commands) {
      if (std::holds_alternative<StopSession>(command)) return Answering::Stopped;
      const auto* const response = std::get_if<RecordResponse>(&command);
      if (response == nullptr) continue;
      record_.response = response_record(*response, question_.response.rt_from, record_);
      return Answering::Done;
    }
    return Answering::GoesOn;
  }

 private:
  /// What the screen depends on.
  struct Shown {
    TrialMachine::Phase phase{};
    std::string answer;
    std::optional<std::size_t> chosen;

    bool operator==(const Shown&) const = default;
  };

  [[nodiscard]] Shown to_be_shown() const {
    return {machine_.phase(), machine_.answer(), machine_.chosen()};
  }

  [[nodiscard]] bool is_shown() const {
    return shown_ == to_be_shown() && booth_.clock.now() - shown_at_ < kShowAgainAfter;
  }

  void show() {
    auto screen = screen_now();
    screen.progress = progress_;
    shown_ = to_be_shown();
    shown_at_ = booth_.display.present(screen, booth_.clock.now()).onset;
  }

  [[nodiscard]] Screen screen_now() const {
    if (machine_.phase() == TrialMachine::Phase::Confirming) return stop_question();
    const auto& response = question_.response;
    if (response.kind == ResponseKind::Typed) {
      return answer_screen(response.prompt, machine_.answer());
    }
    return choice_screen(response, question_.grid, machine_.chosen(), question_.background);
  }

  const Booth& booth_;
  const Question& question_;
  double progress_;
  TrialMachine& machine_;
  TrialRecord& record_;
  std::optional<Shown> shown_;
  Instant shown_at_;
};

}  // namespace

Question question_of(const protocols::Protocol& protocol) {
  const auto& window = protocol.window;
  return {
      .response = protocol.response,
      .grid = grid_of(protocol.response.options, static_cast<double>(window.width) / window.height),
      .background = window.background};
}

TrialRules trial_rules(const protocols::Protocol& protocol, const Question& question) {
  const auto& response = protocol.response;
  TrialRules rules{.fixation = protocol.intervals.fixation,
                   .time_limit = response.time_limit,
                   .longest_answer = static_cast<std::size_t>(response.longest)};
  if (response.kind == ResponseKind::Typed) return rules;
  rules.choice = {.options = response.options,
                  .boxes = response.pointer ? question.grid.boxes : std::vector<OptionBox>{},
                  .confirm = response.confirm};
  rules.from_onset = response.from == protocols::AnswersFrom::Onset;
  return rules;
}

bool collect_answer(const Booth& booth,
                    Oversight& oversight,
                    const Question& question,
                    double progress,
                    TrialMachine& machine,
                    const std::vector<TrialCommand>& at_end,
                    TrialRecord& record) {
  AnswerLoop loop{booth, question, progress, machine, record};
  auto now = loop.take(at_end);
  if (now != Answering::GoesOn) return now == Answering::Done;
  const ShownPointer pointer{booth.keyboard, question.response.pointer};
  while (now == Answering::GoesOn && !oversight.stop_asked()) now = loop.step();
  return now == Answering::Done;
}

void finish_triggers(const Booth& booth,
                     const TrialMachine& machine,
                     TriggerLog& triggers,
                     TrialRecord& record) {
  if (!record.response.timed_out && !machine.answered_early()) {
    triggers.send(protocols::TriggerEvent::Response, Instant{record.response.submitted});
  }
  const auto latest = booth.clock.now() + kTriggerPatience;
  while (!triggers.settled() && booth.clock.now() < latest) {
    booth.display.wait(booth.clock.now() + kPollEvery);  // a refresh would keep the store waiting
  }
  triggers.finish(record, booth.clock.now());
}

std::optional<Duration> since_last_stroke(const Booth& booth,
                                          const TrialMachine& machine,
                                          const TrialRecord& record) {
  if (record.response.timed_out || machine.answered_early()) return std::nullopt;
  return booth.clock.now() - Instant{record.response.submitted};
}

}  // namespace bimodal::runner

// Sessions that are watched, paused and stopped from outside.

#include <deque>
#include <functional>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/booth/session_loop.hpp"
#include "runner/devices/simulated/simulated_audio.hpp"
#include "runner/devices/simulated/simulated_display.hpp"
#include "runner/devices/simulated/simulated_keyboard.hpp"
#include "runner/devices/simulated/virtual_clock.hpp"
#include "runner/store/store_error.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr std::size_t kTrials = 4;
constexpr const char* kPauseText = "A short pause. Please wait.";

std::vector<protocols::PlannedTrial> planned_trials() {
  std::vector<protocols::PlannedTrial> plan(kTrials);
  for (std::size_t i = 0; i < kTrials; ++i) {
    plan[i].index = i;
    plan[i].word = {.spelling = "stew", .phones = {Phone::S, Phone::T, Phone::UW}};
  }
  return plan;
}

/// Half a second of sound, without pictures.
class SoundTrials final : public TrialSource {
 public:
  explicit SoundTrials(const std::vector<protocols::PlannedTrial>& plan) : plan_{plan} {}

  void add_faces() { has_face_ = true; }

  bool ready() override { return waits == 0 || --waits == 0; }

  PreparedTrial next() override {
    PreparedTrial trial{.plan = plan_.at(next_++),
                        .layout = {.recording = 500ms, .has_sound = true}};
    if (has_face_) trial.frames = frame_count(trial.layout, Hertz{60});
    trial.sound = Sound{.rate = Hertz{48'000},
                        .samples = std::make_shared<const std::vector<float>>(24'000, 0.1F)};
    return trial;
  }

  void hold() override { is_held = true; }

  void release() override { is_held = false; }

  int waits = 0;  ///< so often the next trial is not ready
  bool is_held = false;

 private:
  const std::vector<protocols::PlannedTrial>& plan_;
  std::size_t next_ = 0;
  bool has_face_ = false;
};

/// Reports what it shows, except while it is asleep.
class SleepyDisplay final : public Display {
 public:
  SleepyDisplay(VirtualClock& clock) : display_{clock} {}

  Presentation present(const Screen& screen, Instant deadline) override {
    auto shown = display_.present(screen, deadline);
    shown.source = is_asleep ? TimeSource::Predicted : TimeSource::DriverReported;
    if (on_shown) on_shown(screen);
    return shown;
  }

  void wait(Instant until) override { display_.wait(until); }

  [[nodiscard]] RefreshEstimate refresh() const override {
    auto measured = display_.refresh();
    measured.period = period.value_or(measured.period);
    measured.count = 100;
    return measured;
  }

  [[nodiscard]] std::string kind() const override { return "sleepy"; }

  [[nodiscard]] std::string description() const override { return "sleepy"; }

  [[nodiscard]] TimeSource time_source() const override { return TimeSource::DriverReported; }

  bool is_asleep = false;
  std::optional<Duration> period;  ///< that it says it has
  std::function<void(const Screen&)> on_shown;

 private:
  SimulatedDisplay display_;
};

class KeptStore final : public SessionStore {
 public:
  std::int64_t begin(const SessionRecord&, std::span<const PlanRecord>) override { return 1; }

  void add(std::int64_t, const TrialRecord& trial) override {
    if (fails) throw StoreError{"the disk is full"};
    trials.push_back(trial);
  }

  void add(std::int64_t, const PlanRecord&) override {}

  void add(std::int64_t, const EventRecord& event) override { events.push_back(event); }

  void end(std::int64_t, std::string_view, std::string_view) override {}

  void reopen(std::int64_t) override {}

  bool fails = false;
  std::vector<TrialRecord> trials;
  std::vector<EventRecord> events;
};

/// Asks for what the test's script says, and notes what it is told.
class ScriptedOverseer final : public Overseer {
 public:
  void tell(const Progress& progress) override {
    if (on_progress) on_progress(progress);
    if (const auto* const pause = std::get_if<PauseChanged>(&progress)) {
      pauses.push_back(pause->state);
      reason = pause->reason;
    }
    if (const auto* const reached = std::get_if<TrialReached>(&progress)) {
      states.push_back(reached->state);
    }
    if (const auto* const result = std::get_if<TrialResult>(&progress)) {
      responses.push_back(result->response);
    }
    if (const auto* const ended = std::get_if<SessionEnded>(&progress)) {
      outcome = ended->outcome;
      detail = ended->detail;
    }
  }

  std::optional<Request> request() override {
    if (on_request) on_request();
    if (asked.empty()) return std::nullopt;
    const auto oldest = asked.front();
    asked.pop_front();
    return oldest;
  }

  std::function<void(const Progress&)> on_progress;
  std::function<void()> on_request;
  std::deque<Request> asked;
  std::vector<PauseChanged::State> pauses;
  std::vector<TrialState> states;
  std::vector<std::string> responses;
  std::string reason;
  std::string outcome;
  std::string detail;
};

/// Whether a trial has come to a state.
bool is(const Progress& progress, std::size_t trial, TrialState state) {
  const auto* const reached = std::get_if<TrialReached>(&progress);
  return reached != nullptr && reached->trial.index == trial && reached->state == state;
}

bool is_paused(const Progress& progress) {
  const auto* const pause = std::get_if<PauseChanged>(&progress);
  return pause != nullptr && pause->state == PauseChanged::State::Paused;
}

class OverseenSession : public testing::Test {
 protected:
  OverseenSession() {
    protocol_.conditions = {{.name = "A", .auditory_talker = "festival:kal"}};
    display_.observe([this](const Screen& screen, const Presentation& shown) {
      const bool pauses = !screen.captions.empty() && screen.captions[0].text == kPauseText;
      if (pauses) pause_pages_.push_back(shown.onset);
    });
  }

  SessionOutcome run(Keyboard* other_keyboard = nullptr, Display* other_display = nullptr) {
    SimulatedKeyboard typist{clock_};
    StoreWriter writer{store_};
    return run_session(
        {.protocol = protocol_,
         .plan = plan_,
         .booth = {clock_,
                   other_display != nullptr ? *other_display : display_,
                   other_keyboard != nullptr ? *other_keyboard : typist,
                   audio_},
         .trials = trials_,
         .store = writer,
         .begin = [](const RefreshEstimate&) { return std::int64_t{1}; },
         .answer = [](const protocols::PlannedTrial& trial) { return trial.word.spelling; },
         .overseer = &overseer_});
  }

  /// Asks to go on when the pause page has been shown so often.
  void resume_after(std::size_t pages) {
    overseer_.on_request = [this, pages, asked = false]() mutable {
      if (asked || pause_pages_.size() < pages) return;
      overseer_.asked.push_back(Request::Resume);
      asked = true;
    };
  }

  void ask_at(std::size_t trial, TrialState state, Request request) {
    overseer_.on_progress = [this, trial, state, request](const Progress& progress) {
      if (is(progress, trial, state)) overseer_.asked.push_back(request);
    };
  }

  [[nodiscard]] std::vector<std::string> event_kinds() const {
    std::vector<std::string> kinds;
    for (const auto& event : store_.events) kinds.push_back(event.kind);
    return kinds;
  }

  VirtualClock clock_;
  SimulatedDisplay display_{clock_};
  SimulatedAudio audio_{clock_, Hertz{48'000}};
  protocols::Protocol protocol_;
  std::vector<protocols::PlannedTrial> plan_ = planned_trials();
  SoundTrials trials_{plan_};
  KeptStore store_;
  ScriptedOverseer overseer_;
  std::vector<Instant> pause_pages_;
};

using State = PauseChanged::State;

TEST_F(OverseenSession, TellsEveryStateOfEveryTrialAndItsResult) {
  EXPECT_TRUE(run().complete);
  ASSERT_THAT(overseer_.states, SizeIs(5 * kTrials));
  EXPECT_THAT(std::vector(overseer_.states.begin(), overseer_.states.begin() + 5),
              ElementsAre(TrialState::Preparing,
                          TrialState::Fixation,
                          TrialState::Presenting,
                          TrialState::Responding,
                          TrialState::Stored));
  EXPECT_THAT(overseer_.responses, ElementsAre("stew", "stew", "stew", "stew"));
  EXPECT_EQ(overseer_.outcome, "complete");
}

TEST_F(OverseenSession, TakesNoRequestWhileAStimulusIsOn) {
  overseer_.on_request = [this] { EXPECT_FALSE(trials_.is_held); };
  EXPECT_TRUE(run().complete);
}

TEST_F(OverseenSession, PausesAndGoesOnUntilAllTrialsAreStored) {
  ask_at(1, TrialState::Stored, Request::Pause);
  resume_after(100);
  EXPECT_TRUE(run().complete);
  EXPECT_THAT(store_.trials, SizeIs(kTrials));
  EXPECT_THAT(overseer_.pauses, ElementsAre(State::Asked, State::Paused, State::Running));
  EXPECT_THAT(event_kinds(), ElementsAre("paused", "resumed"));
  EXPECT_GT(store_.events[1].at - store_.events[0].at, 1s);
  ASSERT_THAT(pause_pages_, SizeIs(100));
  for (std::size_t i = 1; i < pause_pages_.size(); ++i) {
    EXPECT_LT(pause_pages_[i] - pause_pages_[i - 1], 3 * display_.refresh().period / 2);
  }
}

TEST_F(OverseenSession, PausesAfterTheAnswerThatHasBeenBegun) {
  ask_at(1, TrialState::Responding, Request::Pause);
  std::size_t stored = 0;
  display_.observe([&](const Screen& screen, const Presentation& shown) {
    if (screen.captions.empty() || screen.captions[0].text != kPauseText) return;
    stored = store_.trials.size();
    pause_pages_.push_back(shown.onset);
  });
  resume_after(10);
  EXPECT_TRUE(run().complete);
  EXPECT_EQ(stored, 2U);
  EXPECT_THAT(store_.trials, SizeIs(kTrials));
  EXPECT_EQ(store_.trials[1].response.text, "stew");
}

TEST_F(OverseenSession, TakesBackAPauseThatHasNotBegun) {
  overseer_.on_progress = [this](const Progress& progress) {
    if (!is(progress, 1, TrialState::Responding)) return;
    overseer_.asked = {Request::Pause, Request::Resume};
  };
  EXPECT_TRUE(run().complete);
  EXPECT_THAT(pause_pages_, IsEmpty());
  EXPECT_THAT(store_.events, IsEmpty());
  EXPECT_THAT(overseer_.pauses, ElementsAre(State::Asked, State::Running));
}

TEST_F(OverseenSession, PausesWhileATrialIsBeingPrepared) {
  trials_.waits = 50;
  ask_at(0, TrialState::Preparing, Request::Pause);
  resume_after(10);
  EXPECT_TRUE(run().complete);
  EXPECT_THAT(pause_pages_, SizeIs(10));
}

TEST_F(OverseenSession, PausesOnAPageAndComesBackToIt) {
  protocol_.instructions = {"Listen."};
  overseer_.on_progress = [this](const Progress& progress) {
    const bool first = std::holds_alternative<PageShown>(progress) && overseer_.pauses.empty();
    if (first) overseer_.asked.push_back(Request::Pause);
  };
  resume_after(10);
  EXPECT_TRUE(run().complete);
  EXPECT_THAT(pause_pages_, SizeIs(10));
  EXPECT_THAT(store_.events, IsEmpty());  // nothing is stored before the first trial
}

TEST_F(OverseenSession, StopsAfterAStimulusWithoutStoringTheTrial) {
  ask_at(2, TrialState::Presenting, Request::Stop);
  const auto outcome = run();
  EXPECT_FALSE(outcome.complete);
  EXPECT_EQ(outcome.trials, 2);
  EXPECT_THAT(store_.trials, SizeIs(2));
  EXPECT_THAT(event_kinds(), ElementsAre("stopped"));
  EXPECT_EQ(overseer_.outcome, "stopped");
  EXPECT_EQ(overseer_.states.back(), TrialState::Responding);
}

TEST_F(OverseenSession, StopsBetweenTrialsBeforeTheNextIsShown) {
  ask_at(1, TrialState::Stored, Request::Stop);
  EXPECT_EQ(run().trials, 2);
  EXPECT_THAT(store_.trials, SizeIs(2));
  EXPECT_EQ(overseer_.states.back(), TrialState::Stored);
}

TEST_F(OverseenSession, StopsDuringAPause) {
  overseer_.on_progress = [this](const Progress& progress) {
    if (is(progress, 1, TrialState::Responding)) overseer_.asked.push_back(Request::Pause);
    if (is_paused(progress)) overseer_.asked.push_back(Request::Stop);
  };
  EXPECT_EQ(run().trials, 2);
  EXPECT_THAT(store_.trials, SizeIs(2));
  EXPECT_THAT(event_kinds(), ElementsAre("paused", "stopped"));
}

/// Types without being asked, at every poll.
class RestlessKeyboard final : public Keyboard {
 public:
  explicit RestlessKeyboard(const Clock& clock) : clock_{clock} {}

  std::vector<Keystroke> poll() override {
    return {{.key = key, .text = "x", .at = clock_.now(), .source = "scripted"}};
  }

  void expect(std::string_view, Instant) override {}

  [[nodiscard]] std::string description() const override { return "restless"; }

  Key key = Key::Enter;

 private:
  const Clock& clock_;
};

TEST_F(OverseenSession, ThrowsKeysAwayDuringAPauseExceptEscape) {
  RestlessKeyboard keyboard{clock_};
  ask_at(0, TrialState::Stored, Request::Pause);
  overseer_.on_request = [&] {
    if (pause_pages_.size() == 20) keyboard.key = Key::Text;
    if (pause_pages_.size() == 40) keyboard.key = Key::Escape;  // asks, and confirms
  };
  EXPECT_EQ(run(&keyboard).trials, 1);
  EXPECT_GE(pause_pages_.size(), 40U);
  EXPECT_THAT(event_kinds(), ElementsAre("paused", "stopped"));
}

/// Presses Enter once, at the first poll after it was told to.
class PatientKeyboard final : public Keyboard {
 public:
  explicit PatientKeyboard(const Clock& clock) : typist_{clock}, clock_{clock} {}

  std::vector<Keystroke> poll() override {
    if (!presses_enter) return typist_.poll();
    presses_enter = false;
    return {{.key = Key::Enter, .at = clock_.now(), .source = "scripted"}};
  }

  void expect(std::string_view answer, Instant from) override {
    if (!answer.empty()) typist_.expect(answer, from);
  }

  [[nodiscard]] std::string description() const override { return "patient"; }

  bool presses_enter = false;

 private:
  SimulatedKeyboard typist_;
  const Clock& clock_;
};

TEST_F(OverseenSession, PausesWhenTheScreenFallsAsleepUntilSomebodyThereGoesOn) {
  trials_.add_faces();
  SleepyDisplay display{clock_};
  PatientKeyboard keyboard{clock_};
  std::size_t pages = 0;
  std::size_t stored = 0;
  display.on_shown = [&](const Screen& screen) {
    if (screen.captions.empty() || screen.captions[0].text == kPauseText) return;
    if (!screen.captions[0].text.starts_with("The experiment pauses")) return;
    stored = store_.trials.size();
    display.is_asleep = false;
    keyboard.presses_enter = ++pages == 50;
  };
  overseer_.on_progress = [&](const Progress& progress) {
    if (is(progress, 1, TrialState::Fixation)) display.is_asleep = true;
  };
  EXPECT_TRUE(run(&keyboard, &display).complete);
  EXPECT_EQ(pages, 50U);
  EXPECT_EQ(stored, 2U);
  ASSERT_THAT(store_.trials, SizeIs(kTrials));
  EXPECT_TRUE(store_.trials[1].flagged);
  EXPECT_FALSE(store_.trials[2].flagged);
  EXPECT_THAT(event_kinds(), ElementsAre("paused", "resumed"));
  EXPECT_THAT(store_.events.front().detail, HasSubstr("the screen reports nothing"));
}

TEST_F(OverseenSession, PausesWhenTheScreenHasAnotherRefreshThanBefore) {
  SleepyDisplay display{clock_};
  overseer_.on_progress = [&](const Progress& progress) {
    if (is(progress, 1, TrialState::Stored)) display.period = 13'333us;
  };
  EXPECT_TRUE(run(nullptr, &display).complete);  // the simulated participant goes on by itself
  EXPECT_THAT(store_.trials, SizeIs(kTrials));
  EXPECT_THAT(event_kinds(), ElementsAre("paused", "resumed"));
  EXPECT_THAT(store_.events.front().detail,
              HasSubstr("every 13.33 ms, not every 16.67 ms as before"));
}

TEST_F(OverseenSession, APauseOfTheExperimenterDoesNotEndByEnter) {
  PatientKeyboard keyboard{clock_};
  ask_at(0, TrialState::Stored, Request::Pause);
  overseer_.on_request = [&, asked = false]() mutable {
    if (pause_pages_.size() == 20) keyboard.presses_enter = true;
    if (asked || pause_pages_.size() < 60) return;
    overseer_.asked.push_back(Request::Resume);
    asked = true;
  };
  EXPECT_TRUE(run(&keyboard).complete);
  EXPECT_EQ(pause_pages_.size(), 60U);
}

TEST_F(OverseenSession, IsNotHeldUpByRequestsWithoutEnd) {
  overseer_.on_request = [this] { overseer_.asked.push_back(Request::Resume); };
  EXPECT_TRUE(run().complete);
}

TEST_F(OverseenSession, TellsWhyItFailed) {
  store_.fails = true;
  EXPECT_THROW(static_cast<void>(run()), StoreError);
  EXPECT_EQ(overseer_.outcome, "failed");
  EXPECT_THAT(overseer_.detail, HasSubstr("the disk is full"));
}

}  // namespace
}  // namespace bimodal::runner

#pragma once

// Sessions that are watched, paused and stopped from outside.

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "runner/booth/session_loop.hpp"
#include "runner/devices/simulated/simulated_audio.hpp"
#include "runner/devices/simulated/simulated_display.hpp"
#include "runner/devices/simulated/simulated_keyboard.hpp"
#include "runner/devices/simulated/virtual_clock.hpp"
#include "runner/store/store_error.hpp"

namespace bimodal::runner {

using namespace std::chrono_literals;

inline constexpr std::size_t kTrials = 4;
inline constexpr const char* kPauseText = "A short pause. Please wait.";

inline std::vector<protocols::PlannedTrial> planned_trials() {
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

  void settle() override {}

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
inline bool is(const Progress& progress, std::size_t trial, TrialState state) {
  const auto* const reached = std::get_if<TrialReached>(&progress);
  return reached != nullptr && reached->trial.index == trial && reached->state == state;
}

inline bool is_paused(const Progress& progress) {
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

}  // namespace bimodal::runner

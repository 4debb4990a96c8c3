#pragma once

#include <memory>
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
#include "tests/runner/booth/fake_line.hpp"

namespace bimodal::runner {

using namespace std::chrono_literals;

inline protocols::Protocol protocol() {
  protocols::Protocol made;
  made.instructions = {"Look and listen."};
  made.conditions = {
      {.name = "bimodal", .auditory_talker = "festival:kal", .visual_talker = "face"}};
  made.breaks = {.every_trials = 2, .text = "Rest."};
  made.response.prompt = "Which word?";
  made.farewell = "Thank you.";
  return made;
}

inline std::vector<protocols::PlannedTrial> plan_of(std::size_t trials) {
  std::vector<protocols::PlannedTrial> plan(trials);
  for (std::size_t i = 0; i < trials; ++i) {
    plan[i].index = i;
    plan[i].block = static_cast<int>(i / 2);
    plan[i].word = {.spelling = "stew", .phones = {Phone::S, Phone::T, Phone::UW}};
  }
  return plan;
}

/// Trials of 0.7 s without pictures.
class PlainTrials final : public TrialSource {
 public:
  explicit PlainTrials(const std::vector<protocols::PlannedTrial>& plan) : plan_{plan} {}

  bool ready() override { return true; }

  PreparedTrial next() override {
    PreparedTrial trial{.plan = plan_.at(next_++),
                        .layout = {.recording = 700ms,
                                   .lead = 500ms,
                                   .trail = 500ms,
                                   .sound_lead = 500ms,
                                   .sound_trail = 500ms,
                                   .av_offset = av_offset,
                                   .has_sound = true}};
    if (has_face) trial.frames = frame_count(trial.layout, Hertz{60});
    trial.sound = Sound{.rate = Hertz{48'000},
                        .samples = std::make_shared<const std::vector<float>>(81'600, 0.1F)};
    trial.offset_tolerance = offset_tolerance;
    return trial;
  }

  void hold() override {}

  void release() override {}

  void begin_anew() { next_ = 0; }

  [[nodiscard]] std::size_t given() const { return next_; }

  Duration av_offset{};
  Duration offset_tolerance = 4ms;
  bool has_face = true;

 private:
  const std::vector<protocols::PlannedTrial>& plan_;
  std::size_t next_ = 0;
};

class MemoryStore final : public SessionStore {
 public:
  std::int64_t begin(const SessionRecord& /*session*/,
                     std::span<const PlanRecord> /*plan*/) override {
    return 7;
  }

  void add(std::int64_t session, const TrialRecord& trial) override {
    EXPECT_EQ(session, 7);
    if (static_cast<int>(trials.size()) == fail_at) throw StoreError{"the disk is full"};
    trials.push_back(trial);
  }

  void add(std::int64_t /*session*/, const PlanRecord& planned) override {
    more.push_back(planned);
  }

  void add(std::int64_t /*session*/, const EventRecord& event) override { events.push_back(event); }

  void reopen(std::int64_t /*session*/) override {}

  void settle() override {}

  void end(std::int64_t /*session*/, std::string_view /*how*/, std::string_view /*when*/) override {
  }

  int fail_at = -1;
  std::vector<TrialRecord> trials;
  std::vector<PlanRecord> more;  ///< planned during the session
  std::vector<EventRecord> events;
};

/// Presses the given keys, one at every 400th poll: longer than a stimulus lasts.
class ScriptedKeyboard final : public Keyboard {
 public:
  ScriptedKeyboard(const Clock& clock, std::vector<Key> keys)
      : clock_{clock}, keys_{std::move(keys)} {}

  std::vector<Keystroke> poll() override {
    if (next_ == keys_.size() || ++polls_ % 400 != 0) return {};
    return {{.key = keys_[next_++], .text = "x", .at = clock_.now(), .source = "scripted"}};
  }

  void expect(std::string_view /*answer*/, Instant /*from*/) override {}

  [[nodiscard]] std::string description() const override { return "scripted"; }

 private:
  const Clock& clock_;
  std::vector<Key> keys_;
  std::size_t next_ = 0;
  int polls_ = 0;
};

class SessionLoopTest : public testing::Test {
 protected:
  SessionOutcome run(std::size_t trials,
                     Keyboard* other_keyboard = nullptr,
                     AudioOutput* other_audio = nullptr) {
    plan_ = plan_of(trials);
    SimulatedKeyboard typist{clock_};
    StoreWriter writer{store_};
    SessionParts parts{.protocol = protocol_,
                       .plan = plan_,
                       .booth = {clock_,
                                 display_,
                                 other_keyboard != nullptr ? *other_keyboard : typist,
                                 other_audio != nullptr ? *other_audio : audio_,
                                 std::vector<TriggerLine*>{&line_},
                                 reference_},
                       .trials = trials_,
                       .store = writer,
                       .begin = [](const RefreshEstimate&) { return std::int64_t{7}; },
                       .plan_record =
                           [](const protocols::PlannedTrial& trial) {
                             return PlanRecord{.trial = static_cast<int>(trial.index),
                                               .block = trial.block,
                                               .word = trial.word.spelling};
                           },
                       .announce = [this](std::string_view what) { told_.emplace_back(what); }};
    if (other_keyboard == nullptr) {
      parts.answer = [](const protocols::PlannedTrial& trial) { return trial.word.spelling; };
    }
    return run_session(parts);
  }

  /// One trial on another display.
  void run_on(SimulatedDisplay& display) {
    plan_ = plan_of(1);
    SimulatedKeyboard typist{clock_};
    StoreWriter writer{store_};
    static_cast<void>(run_session(
        {.protocol = protocol_,
         .plan = plan_,
         .booth = {clock_, display, typist, audio_},
         .trials = trials_,
         .store = writer,
         .begin = [](const RefreshEstimate&) { return std::int64_t{7}; },
         .answer = [](const protocols::PlannedTrial&) { return std::string{"stew"}; }}));
  }

  VirtualClock clock_;
  SimulatedDisplay display_{clock_};
  SimulatedAudio audio_{clock_, Hertz{48'000}};
  protocols::Protocol protocol_ = protocol();
  std::vector<protocols::PlannedTrial> plan_;
  PlainTrials trials_{plan_};
  MemoryStore store_;
  FakeLine line_{"socket"};
  OnsetReference reference_;
  std::vector<std::string> told_;
};

}  // namespace bimodal::runner

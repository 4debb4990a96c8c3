#include "runner/booth/session_loop.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/devices/device_error.hpp"
#include "runner/devices/simulated/simulated_audio.hpp"
#include "runner/devices/simulated/simulated_display.hpp"
#include "runner/devices/simulated/simulated_keyboard.hpp"
#include "runner/devices/simulated/virtual_clock.hpp"
#include "runner/session/option_grid.hpp"
#include "runner/store/store_error.hpp"
#include "tests/runner/booth/fake_line.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;

protocols::Protocol protocol() {
  protocols::Protocol made;
  made.instructions = {"Look and listen."};
  made.conditions = {
      {.name = "bimodal", .auditory_talker = "festival:kal", .visual_talker = "face"}};
  made.breaks = {.every_trials = 2, .text = "Rest."};
  made.response.prompt = "Which word?";
  made.farewell = "Thank you.";
  return made;
}

std::vector<protocols::PlannedTrial> plan_of(std::size_t trials) {
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
                                 std::vector<TriggerLine*>{&line_}},
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
  std::vector<std::string> told_;
};

TEST_F(SessionLoopTest, StoresEveryTrialWithItsAnswer) {
  const auto outcome = run(5);
  EXPECT_TRUE(outcome.complete);
  EXPECT_EQ(outcome.trials, 5);
  EXPECT_EQ(outcome.flagged, 0);
  ASSERT_EQ(store_.trials.size(), 5U);
  for (const auto& trial : store_.trials) {
    EXPECT_EQ(trial.response.text, "stew");
    EXPECT_EQ(trial.keystrokes.size(), 5U);
    EXPECT_GT(trial.response.submitted, trial.stimulus_end);
  }
  EXPECT_EQ(store_.events.size(), 2U);  // the breaks
}

TEST_F(SessionLoopTest, ShowsEveryFrameOnceAndInTime) {
  static_cast<void>(run(1));
  const auto& refreshes = store_.trials.at(0).refreshes;
  ASSERT_EQ(refreshes.frame.size(), 102U);
  for (std::size_t i = 0; i < refreshes.frame.size(); ++i) {
    EXPECT_EQ(refreshes.frame[i], static_cast<std::int64_t>(i));
    EXPECT_EQ(refreshes.shown[i], refreshes.planned[i]);
  }
}

TEST_F(SessionLoopTest, KeepsToThePreparedFramesWhenTheDisplayIsOfAnotherRate) {
  SimulatedDisplay slower{clock_, {.rate = Hertz{57.0}}};
  run_on(slower);
  const auto& refreshes = store_.trials.at(0).refreshes;
  // 102 frames of 1/60 s last 96.9 refreshes of 1/57 s; the lead takes 28 of its 28.5.
  EXPECT_EQ(refreshes.frame.size(), 96U);
  EXPECT_LE(refreshes.frame.back(), 101);
  EXPECT_TRUE(std::ranges::is_sorted(refreshes.frame));
}

TEST_F(SessionLoopTest, ReportsTheOnsetOfTheFrameOfTimeZeroHoweverLittleTheRatesDiffer) {
  SimulatedDisplay faster{clock_, {.rate = Hertz{60.01}}};
  run_on(faster);
  const auto& visual = store_.trials.at(0).onsets.at(0);
  ASSERT_EQ(visual.modality, "visual");
  const Duration error = *visual.reported - visual.planned;
  EXPECT_NEAR(std::chrono::duration<double>(error).count(), 0.0, 1e-6);
}

TEST_F(SessionLoopTest, StatesTheAudioVisualOffsetAsAudioMinusVisual) {
  trials_.av_offset = 80ms;
  static_cast<void>(run(1));
  const auto& onsets = store_.trials.at(0).onsets;
  ASSERT_EQ(onsets.size(), 2U);
  EXPECT_EQ(onsets[0].modality, "visual");
  EXPECT_NEAR(std::chrono::duration<double>(*onsets[1].reported - *onsets[0].reported).count(),
              0.080,
              1e-6);
}

TEST_F(SessionLoopTest, TellsOtherEquipmentWhenTrialsBeginAndWhenTheyAreAnswered) {
  std::vector<Instant> fixations;
  bool was_fixation = false;
  display_.observe([&](const Screen& screen, const Presentation& shown) {
    if (screen.fixation && !was_fixation) fixations.push_back(shown.onset);
    was_fixation = screen.fixation;
  });
  static_cast<void>(run(3));
  ASSERT_EQ(store_.trials.size(), 3U);
  ASSERT_EQ(fixations.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& triggers = store_.trials[i].triggers;
    ASSERT_EQ(triggers.size(), 5U);
    EXPECT_EQ(triggers.front().event, "trial_start");
    EXPECT_EQ(triggers.front().planned, fixations[i].time_since_epoch());
    EXPECT_EQ(triggers.back().event, "response");
    EXPECT_EQ(triggers.back().planned, store_.trials[i].response.submitted);
    EXPECT_TRUE(triggers.back().sent.has_value());
    EXPECT_EQ(line_.signals.at(5 * i).trial, static_cast<int>(i));
    EXPECT_EQ(line_.signals.at(5 * i).condition, "bimodal");
  }
}

TEST_F(SessionLoopTest, TellsNobodyOfAnAnswerThatWasNotGiven) {
  protocol_.response.time_limit = 100ms;
  static_cast<void>(run(1));
  ASSERT_TRUE(store_.trials.at(0).response.timed_out);
  EXPECT_EQ(store_.trials.at(0).triggers.back().event, "stimulus_end");
}

TEST_F(SessionLoopTest, FlagsATrialWhoseFramesWereLateAndSaysHowMany) {
  int presented = 0;
  display_.observe([&](const Screen& screen, const Presentation&) {
    if (!screen.captions.empty()) return;
    if (++presented == 40) display_.drop_next(3);
  });
  const auto outcome = run(2);
  EXPECT_EQ(outcome.flagged, 1);
  const auto& trial = store_.trials.at(0);
  EXPECT_TRUE(trial.flagged);
  ASSERT_EQ(trial.events.size(), 1U);
  EXPECT_EQ(trial.events[0].kind, "late_frame");
  EXPECT_EQ(trial.refreshes.frame.size(), 99U);  // three left out rather than shown late
}

/// Makes three frames late in the trials of these places, counted from 0 as they are presented.
void make_late(SimulatedDisplay& display, std::set<int> trials) {
  display.observe([&display, trials = std::move(trials), trial = -1, frames = 0](
                      const Screen& screen, const Presentation&) mutable {
    if (!screen.captions.empty()) frames = 0;
    if (!screen.captions.empty() || ++frames != 80) return;
    if (trials.contains(++trial)) display.drop_next(3);
  });
}

std::vector<int> numbers(const std::vector<TrialRecord>& trials) {
  std::vector<int> all;
  for (const auto& trial : trials) all.push_back(trial.trial);
  return all;
}

TEST_F(SessionLoopTest, ExcludesFlaggedTrialsOnlyIfTheProtocolSaysSo) {
  for (const auto rule : {protocols::Flagged::Keep, protocols::Flagged::Exclude}) {
    protocol_.timing.flagged = rule;
    store_.trials.clear();
    trials_.begin_anew();
    make_late(display_, {1});
    static_cast<void>(run(3));
    ASSERT_EQ(store_.trials.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(store_.trials[i].flagged, i == 1);
      EXPECT_EQ(store_.trials[i].excluded, i == 1 && rule == protocols::Flagged::Exclude);
    }
  }
}

TEST_F(SessionLoopTest, PresentsFlaggedTrialsAgainAtTheEndOfTheirBlock) {
  protocol_.timing.flagged = protocols::Flagged::Repeat;
  make_late(display_, {0, 1, 2, 6});  // of 0 1 | 0 1 0 | 2 3 | 4 | 4 in this order
  const auto outcome = run(5);
  EXPECT_TRUE(outcome.complete);
  EXPECT_EQ(outcome.trials, 5);
  EXPECT_EQ(outcome.repeated, 4);
  EXPECT_EQ(outcome.flagged, 4);
  EXPECT_THAT(numbers(store_.trials), testing::ElementsAre(0, 1, 5, 6, 7, 2, 3, 8, 4));
  ASSERT_EQ(store_.more.size(), 4U);
  const std::vector<int> originals{0, 1, 0, 3};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(store_.more[i].trial, static_cast<int>(5 + i));
    EXPECT_EQ(store_.more[i].repeats, originals[i]);
  }
  EXPECT_TRUE(store_.trials[2].excluded);
  EXPECT_FALSE(store_.trials[4].excluded);
  EXPECT_EQ(store_.events.size(), 2U);  // the breaks, each after its block's repetitions
}

TEST_F(SessionLoopTest, RepeatsATrialAsOftenAsTheProtocolAllows) {
  protocol_.timing.flagged = protocols::Flagged::Repeat;
  protocol_.timing.most_repeats = 2;
  make_late(display_, {0, 1, 2, 3, 4, 5});
  const auto outcome = run(1);
  EXPECT_TRUE(outcome.complete);
  EXPECT_EQ(outcome.repeated, 2);
  EXPECT_THAT(numbers(store_.trials), testing::ElementsAre(0, 1, 2));
  EXPECT_TRUE(std::ranges::all_of(store_.trials, &TrialRecord::excluded));
}

TEST_F(SessionLoopTest, RepeatsTheVerySameSoundAndSaysSo) {
  protocol_.timing.flagged = protocols::Flagged::Repeat;
  make_late(display_, {0});
  static_cast<void>(run(1));
  ASSERT_EQ(store_.trials.size(), 2U);
  EXPECT_EQ(trials_.given(), 1U);
  EXPECT_EQ(line_.signals.back().trial, 1);
  EXPECT_THAT(told_,
              testing::ElementsAre("trial 1 of 1: bimodal",
                                   "trial 1 again, its timing was not as planned: bimodal"));
}

TEST_F(SessionLoopTest, IsNotCompleteIfARepetitionIsMissing) {
  protocol_.timing.flagged = protocols::Flagged::Repeat;
  make_late(display_, {0});
  ScriptedKeyboard keyboard{clock_, {Key::Enter, Key::Enter, Key::Escape, Key::Escape}};
  const auto outcome = run(1, &keyboard);
  EXPECT_EQ(outcome.trials, 1);
  EXPECT_EQ(outcome.repeated, 0);
  EXPECT_FALSE(outcome.complete);
}

TEST_F(SessionLoopTest, TellsTheOnsetOfTimeZeroAlsoIfItsFrameWasLeftOut) {
  int frames = 0;
  display_.observe([&](const Screen& screen, const Presentation&) {
    if (screen.captions.empty() && !screen.fixation && ++frames == 29) display_.drop_next(1);
  });
  static_cast<void>(run(1));
  const auto& trial = store_.trials.at(0);
  ASSERT_EQ(std::ranges::count(trial.refreshes.frame, 30), 0);
  ASSERT_EQ(std::ranges::count(trial.refreshes.frame, 31), 1);
  const Duration error = *trial.onsets.at(0).reported - trial.onsets.at(0).planned;
  EXPECT_LT(std::chrono::abs(error), 1us);
  EXPECT_TRUE(trial.flagged);
}

/// Loses its device with the first sound.
class LostAudio final : public AudioOutput {
 public:
  void schedule(const Sound& /*sound*/, Instant /*onset*/) override {}

  void move(Instant /*onset*/) override {}

  void stop() override {}

  [[nodiscard]] Playback playback() override { return {.finished = true, .lost = true}; }

  [[nodiscard]] Duration lead_time() const override { return {}; }

  [[nodiscard]] Hertz rate() const override { return Hertz{48'000}; }

  [[nodiscard]] std::string kind() const override { return "portaudio"; }

  [[nodiscard]] std::string description() const override { return "lost"; }

  [[nodiscard]] std::string_view time_source() const override { return "stream_time"; }
};

TEST_F(SessionLoopTest, StoresNoTrialWhoseSoundWasLost) {
  plan_ = plan_of(2);
  LostAudio lost;
  SimulatedKeyboard typist{clock_};
  StoreWriter writer{store_};
  const SessionParts parts{
      .protocol = protocol_,
      .plan = plan_,
      .booth = {clock_, display_, typist, lost},
      .trials = trials_,
      .store = writer,
      .begin = [](const RefreshEstimate&) { return std::int64_t{7}; },
      .answer = [](const protocols::PlannedTrial&) { return std::string{"stew"}; }};
  EXPECT_THROW(static_cast<void>(run_session(parts)), DeviceError);
  EXPECT_THAT(store_.trials, testing::IsEmpty());
}

/// Is heard a millisecond and a half late.
class TardyAudio final : public AudioOutput {
 public:
  explicit TardyAudio(const Clock& clock) : audio_{clock, Hertz{48'000}} {}

  void schedule(const Sound& sound, Instant onset) override { audio_.schedule(sound, onset); }

  void move(Instant onset) override { audio_.move(onset); }

  void stop() override { audio_.stop(); }

  [[nodiscard]] Playback playback() override {
    auto playback = audio_.playback();
    if (playback.onset) *playback.onset += 1500us;
    return playback;
  }

  [[nodiscard]] Duration lead_time() const override { return audio_.lead_time(); }

  [[nodiscard]] Hertz rate() const override { return audio_.rate(); }

  [[nodiscard]] std::string kind() const override { return "tardy"; }

  [[nodiscard]] std::string description() const override { return "tardy"; }

  [[nodiscard]] std::string_view time_source() const override { return "stream_time"; }

 private:
  SimulatedAudio audio_;
};

TEST_F(SessionLoopTest, FlagsAnOffsetBeyondTheToleranceOfTheProtocol) {
  for (const Duration tolerance : {1ms, 2ms}) {
    trials_.offset_tolerance = tolerance;
    trials_.begin_anew();
    store_.trials.clear();
    TardyAudio tardy{clock_};
    static_cast<void>(run(1, nullptr, &tardy));
    EXPECT_EQ(store_.trials.at(0).flagged, tolerance == 1ms);
  }
}

TEST_F(SessionLoopTest, CountsReactionTimeFromTheOnsetThatTheProtocolNames) {
  trials_.av_offset = 80ms;
  const std::vector<std::pair<protocols::RtFrom, std::string>> cases{
      {protocols::RtFrom::End, "end"},
      {protocols::RtFrom::SoundOnset, "sound_onset"},
      {protocols::RtFrom::VisualOnset, "visual_onset"}};
  for (const auto& [from, name] : cases) {
    protocol_.response.rt_from = from;
    trials_.begin_anew();
    store_.trials.clear();
    TardyAudio tardy{clock_};
    static_cast<void>(run(1, nullptr, &tardy));
    const auto& trial = store_.trials.at(0);
    EXPECT_EQ(trial.response.reference, name);
    const auto seen = *trial.onsets.at(0).reported;
    const auto heard = *trial.onsets.at(1).reported;
    ASSERT_NEAR(std::chrono::duration<double>(heard - seen).count(), 0.0815, 1e-6);
    EXPECT_EQ(trial.response.reference_at,
              from == protocols::RtFrom::End          ? trial.stimulus_end
              : from == protocols::RtFrom::SoundOnset ? heard
                                                      : seen);
  }
}

/// Gives one stroke at a fixed time of each trial, counted from the first fixation mark after the
/// pointer was hidden or a page; remembers whether the pointer is shown.
class ChoosingKeyboard final : public Keyboard {
 public:
  ChoosingKeyboard(VirtualClock& clock, SimulatedDisplay& display, Keystroke stroke, Duration after)
      : clock_{clock}, stroke_{std::move(stroke)}, after_{after} {
    display.observe([this](const Screen& screen, const Presentation& shown) {
      if (screen.fixation && !was_fixation_) due_ = shown.onset + after_;
      was_fixation_ = screen.fixation;
      if (!screen.captions.empty()) answer_screens_.push_back(screen);
      if (screen.captions.empty() && pointer_shown) pointer_outside = true;
    });
  }

  std::vector<Keystroke> poll() override {
    if (!due_ || clock_.now() < *due_) return {};
    auto stroke = stroke_;
    stroke.at = *due_;
    due_.reset();
    return {stroke};
  }

  void expect(std::string_view, Instant) override {}

  void show_pointer(bool shown) override { pointer_shown = shown; }

  [[nodiscard]] std::string description() const override { return "choosing"; }

  [[nodiscard]] const std::vector<Screen>& answer_screens() const { return answer_screens_; }

  bool pointer_shown = false;
  bool pointer_outside = false;  ///< while no question was on the screen

 private:
  VirtualClock& clock_;
  Keystroke stroke_;
  Duration after_;
  bool was_fixation_ = false;
  std::optional<Instant> due_;
  std::vector<Screen> answer_screens_;
};

protocols::Response choice() {
  return {.kind = protocols::ResponseKind::Choice,
          .prompt = "ba or wa?",
          .options = {{.label = "ba", .key = "b", .button = 7}, {.label = "wa", .key = "w"}}};
}

TEST_F(SessionLoopTest, StoresTheLabelOfAChoiceWithItsStrokeAndUncertainty) {
  protocol_.instructions.clear();
  protocol_.farewell.clear();
  protocol_.response = choice();
  ChoosingKeyboard keyboard{
      clock_,
      display_,
      {.key = Key::Button, .uncertainty = 3ms, .source = "evdev", .button = 7},
      4s};
  static_cast<void>(run(2, &keyboard));
  ASSERT_EQ(store_.trials.size(), 2U);
  for (const auto& trial : store_.trials) {
    EXPECT_EQ(trial.response.text, "ba");
    EXPECT_EQ(trial.response.uncertainty, 3ms);
    EXPECT_EQ(trial.response.reference_at, trial.stimulus_end);
    ASSERT_EQ(trial.keystrokes.size(), 1U);
    EXPECT_EQ(trial.keystrokes[0].key, "Button7");
    EXPECT_EQ(trial.keystrokes[0].at, trial.response.submitted);
  }
  const auto& screen = keyboard.answer_screens().at(0);
  EXPECT_EQ(screen.marks.size(), 2U);
  EXPECT_EQ(screen.captions.at(0).text, "ba or wa?");
  EXPECT_EQ(screen.captions.at(1).text, "ba");
  EXPECT_EQ(screen.captions.at(2).text, "b");
}

TEST_F(SessionLoopTest, TakesClicksIntoTheBoxesThatAreShownAndHidesThePointerAfterwards) {
  protocol_.instructions.clear();
  protocol_.farewell.clear();
  protocol_.response = choice();
  protocol_.response.pointer = true;
  const auto grid = grid_of(protocol_.response.options, 1.25);
  ChoosingKeyboard keyboard{clock_,
                            display_,
                            {.key = Key::Pointer,
                             .button = 1,
                             .x = grid.boxes.at(1).centre_x,
                             .y = grid.boxes.at(1).centre_y},
                            4s};
  static_cast<void>(run(1, &keyboard));
  EXPECT_EQ(store_.trials.at(0).response.text, "wa");
  EXPECT_EQ(store_.trials.at(0).keystrokes.at(0).x, grid.boxes[1].centre_x);
  EXPECT_FALSE(keyboard.pointer_shown);
  EXPECT_FALSE(keyboard.pointer_outside);
  const auto& marks = keyboard.answer_screens().at(0).marks;
  EXPECT_EQ(marks.at(1).centre_x, grid.boxes[1].centre_x);
}

TEST_F(SessionLoopTest, EndsATrialAfterTheStimulusIfItWasAnsweredDuringIt) {
  protocol_.instructions.clear();
  protocol_.farewell.clear();
  protocol_.response = choice();
  protocol_.response.from = protocols::AnswersFrom::Onset;
  protocol_.response.rt_from = protocols::RtFrom::SoundOnset;
  ChoosingKeyboard keyboard{clock_, display_, {.key = Key::Text, .text = "w"}, 1'600ms};
  static_cast<void>(run(1, &keyboard));
  const auto& trial = store_.trials.at(0);
  EXPECT_EQ(trial.response.text, "wa");
  EXPECT_EQ(trial.refreshes.frame.size(), 102U);  // shown to its end
  EXPECT_LT(trial.response.submitted, trial.stimulus_end);
  EXPECT_GT(trial.response.submitted, *trial.response.reference_at);
  EXPECT_EQ(trial.keystrokes.size(), 1U);
  EXPECT_TRUE(keyboard.answer_screens().empty());
  const auto responses = std::ranges::count(trial.triggers, "response", &TriggerRecord::event);
  EXPECT_EQ(responses, 1);
  EXPECT_EQ(trial.triggers.back().event, "stimulus_end");  // the answer was told before
}

TEST_F(SessionLoopTest, TakesNoAnswerBeforeTheOnset) {
  protocol_.instructions.clear();
  protocol_.farewell.clear();
  protocol_.response = choice();
  protocol_.response.from = protocols::AnswersFrom::Onset;
  protocol_.response.time_limit = 200ms;
  ChoosingKeyboard keyboard{clock_, display_, {.key = Key::Text, .text = "w"}, 900ms};
  static_cast<void>(run(1, &keyboard));
  EXPECT_TRUE(store_.trials.at(0).response.timed_out);
  EXPECT_EQ(store_.trials.at(0).response.text, "");
}

TEST_F(SessionLoopTest, DoesNotFlagATrialWithoutFaceForALateFixationMark) {
  trials_.has_face = false;
  int presented = 0;
  display_.observe([&](const Screen& screen, const Presentation&) {
    if (screen.fixation && ++presented == 60) display_.drop_next(3);
  });
  const auto outcome = run(1);
  ASSERT_GT(presented, 60);
  EXPECT_EQ(outcome.flagged, 0);
  EXPECT_THAT(store_.trials.at(0).events, testing::IsEmpty());
}

TEST_F(SessionLoopTest, ShowsTheFixationMarkAtEveryRefreshUntilTheStimulusBegins) {
  std::vector<Instant> refreshes;
  display_.observe([&](const Screen& screen, const Presentation& shown) {
    if (screen.captions.empty() && screen.fixation) refreshes.push_back(shown.onset);
  });
  trials_.has_face = false;  // the mark stays during the sound
  static_cast<void>(run(1));
  ASSERT_GT(refreshes.size(), 100U);
  const Duration period = display_.refresh().period;
  for (std::size_t i = 1; i < refreshes.size(); ++i) {
    ASSERT_LT(refreshes[i] - refreshes[i - 1], 3 * period / 2) << "refresh " << i;
  }
}

TEST_F(SessionLoopTest, StopsAndShowsANeutralScreenWhenDataCannotBeKept) {
  store_.fail_at = 1;
  bool neutral = false;
  display_.observe([&](const Screen& screen, const Presentation&) {
    neutral = screen.captions.empty() && screen.picture == nullptr && !screen.fixation;
  });
  EXPECT_THROW(static_cast<void>(run(3)), StoreError);
  EXPECT_TRUE(neutral);
  EXPECT_EQ(store_.trials.size(), 1U);
}

TEST_F(SessionLoopTest, AsksBeforeItStopsOnAPage) {
  ScriptedKeyboard keyboard{clock_, {Key::Escape, Key::Enter, Key::Escape, Key::Escape}};
  const auto outcome = run(2, &keyboard);
  EXPECT_FALSE(outcome.complete);
  EXPECT_EQ(outcome.session, std::nullopt);
}

TEST_F(SessionLoopTest, DoesNotStoreTheTrialInWhichItWasStopped) {
  ScriptedKeyboard keyboard{clock_, {Key::Enter, Key::Escape, Key::Escape}};
  const auto outcome = run(2, &keyboard);
  EXPECT_FALSE(outcome.complete);
  EXPECT_EQ(outcome.session, 7);
  EXPECT_TRUE(store_.trials.empty());
  ASSERT_EQ(store_.events.size(), 1U);
  EXPECT_EQ(store_.events[0].kind, "stopped");
}

}  // namespace
}  // namespace bimodal::runner

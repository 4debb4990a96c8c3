// What other equipment is told in the course of a stimulus, and what is written down about it.
#include <algorithm>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/booth/patch.hpp"
#include "runner/booth/stimulus_presentation.hpp"
#include "runner/devices/silent/silent_audio.hpp"
#include "runner/devices/simulated/simulated_audio.hpp"
#include "runner/devices/simulated/simulated_display.hpp"
#include "runner/devices/simulated/simulated_keyboard.hpp"
#include "tests/runner/booth/fake_line.hpp"
#include "tests/runner/realtime/count_allocations.hpp"

namespace bimodal::runner {
namespace {

using namespace std::chrono_literals;
using protocols::TriggerEvent;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class TriggerTest : public testing::Test {
 protected:
  TriggerTest() {
    triggers_.photodiode = protocols::Photodiode{};
    triggers_.click = protocols::Click{.channel = 3};
    triggers_.serial = protocols::SerialTriggers{
        .port = "x", .codes = {std::nullopt, 1, 2, std::nullopt, std::nullopt}};
    display_.observe([this](const Screen& screen, const Presentation& shown) {
      const bool lit = screen.marks.back().colour[0] > 0.5F;
      if (lit && !was_lit_) lit_.push_back(shown.onset);
      was_lit_ = lit;
    });
  }

  /// 0.5 s of lead, then 0.7 s of speech.
  PreparedTrial trial(bool has_sound, bool has_face, Duration av_offset = {}) {
    PreparedTrial made{.layout = {.recording = 700ms,
                                  .lead = 500ms,
                                  .trail = 500ms,
                                  .sound_lead = 500ms,
                                  .sound_trail = 500ms,
                                  .av_offset = av_offset,
                                  .has_sound = has_sound}};
    if (has_face) made.frames = frame_count(made.layout, Hertz{60});
    if (has_sound) {
      made.sound = Sound{.rate = Hertz{48'000},
                         .samples = std::make_shared<const std::vector<float>>(81'600, 0.1F)};
    }
    return made;
  }

  CueSheet cues_for(const PreparedTrial& trial) {
    const auto refresh = display_.refresh();
    return CueSheet{
        trial.layout, trial.drawing_rate, refresh, clock_.now() + 100ms, clock_.now() + 100ms};
  }

  /// Presents the trial as the session loop does, up to the answer.
  TrialRecord present(const PreparedTrial& trial, CueSheet& cues, AudioOutput& audio) {
    TrialRecord record;
    record.trial = 4;
    TrialMachine machine{{}};
    const Booth booth{
        clock_, patched_, keyboard_, audio, std::vector<TriggerLine*>{&serial_, &socket_}};
    TriggerLog log{triggers_, booth.trigger_lines};
    log.begin(record.trial, "AV");
    log.send(TriggerEvent::TrialStart, clock_.now());
    present_stimulus(booth, trial, cues, machine, log, record);
    log.send(TriggerEvent::Response, clock_.now());
    settled_ = log.settled();
    log.finish(record, clock_.now());
    return record;
  }

  TrialRecord present(const PreparedTrial& trial) {
    cues_ = std::make_unique<CueSheet>(cues_for(trial));
    return present(trial, *cues_, audio_);
  }

  /// Between two trials.
  void forget_signals() {
    serial_.forget();
    socket_.forget();
    clock_.advance_by(1s);
  }

  /// The trigger of a kind that stands for an event; fails if there is not one.
  static TriggerRecord the(const TrialRecord& record,
                           std::string_view kind,
                           std::string_view event) {
    const auto is_meant = [&](const TriggerRecord& trigger) {
      return trigger.kind == kind && trigger.event == event;
    };
    EXPECT_EQ(std::ranges::count_if(record.triggers, is_meant), 1) << kind << " " << event;
    const auto found = std::ranges::find_if(record.triggers, is_meant);
    return found == record.triggers.end() ? TriggerRecord{} : *found;
  }

  static std::vector<std::string> events_of(const TrialRecord& record, std::string_view kind) {
    std::vector<std::string> events;
    for (const auto& trigger : record.triggers) {
      if (trigger.kind == kind) events.push_back(trigger.event);
    }
    return events;
  }

  VirtualClock clock_;
  SimulatedDisplay display_{clock_};
  PatchedDisplay patched_{display_, patch_of({}, 1280, 1024)};
  SimulatedAudio audio_{clock_, Hertz{48'000}};
  SimulatedKeyboard keyboard_{clock_};
  FakeLine serial_{"serial"};
  FakeLine socket_{"socket"};
  protocols::Triggers triggers_;
  std::unique_ptr<CueSheet> cues_;
  std::vector<Instant> lit_;  ///< refreshes at which the patch changed
  bool was_lit_ = false;
  bool settled_ = false;
};

TEST_F(TriggerTest, PatchChangesAtTheVeryRefreshOfTheFrameOfTimeZero) {
  const auto record = present(trial(true, true));
  EXPECT_THAT(lit_, ElementsAre(cues_->visual_zero()));
  const auto patch = the(record, "photodiode", "visual_zero");
  EXPECT_EQ(patch.planned, cues_->visual_zero().time_since_epoch());
  EXPECT_EQ(patch.sent, patch.planned);
  EXPECT_EQ(patch.source, "predicted");
  EXPECT_EQ(patch.code, std::nullopt);
  const auto refresh = std::ranges::find(record.refreshes.shown, patch.sent);
  ASSERT_NE(refresh, record.refreshes.shown.end());
  EXPECT_EQ(
      record.refreshes.frame.at(static_cast<std::size_t>(refresh - record.refreshes.shown.begin())),
      30);
}

TEST_F(TriggerTest, PatchChangesWithTheNextFrameIfThatOfTimeZeroWasLeftOut) {
  const auto made = trial(true, true);
  int frames = 0;
  display_.observe([&](const Screen& screen, const Presentation& shown) {
    const bool lit = screen.marks.back().colour[0] > 0.5F;
    if (lit && !was_lit_) lit_.push_back(shown.onset);
    was_lit_ = lit;
    if (!screen.fixation && ++frames == 29) display_.drop_next(1);
  });
  const auto record = present(made);
  ASSERT_EQ(std::ranges::count(record.refreshes.frame, 30), 0);
  const auto period = display_.refresh().period;
  EXPECT_THAT(lit_, ElementsAre(cues_->visual_zero() + period));
  EXPECT_EQ(the(record, "photodiode", "visual_zero").sent,
            (cues_->visual_zero() + period).time_since_epoch());
  EXPECT_EQ(the(record, "photodiode", "visual_zero").planned,
            cues_->visual_zero().time_since_epoch());
}

TEST_F(TriggerTest, PatchMarksTheRefreshNearestToAuditoryZeroWhereNobodyIsSeen) {
  const auto period = display_.refresh().period;
  for (const auto offset : {Duration{0}, Duration{40ms}, Duration{-100ms}}) {
    lit_.clear();
    const auto record = present(trial(true, false, offset));
    ASSERT_EQ(lit_.size(), 1U);
    EXPECT_LE(std::chrono::abs(lit_.front() - cues_->auditory_zero()), period / 2);
    const auto patch = the(record, "photodiode", "auditory_zero");
    EXPECT_EQ(patch.planned, cues_->auditory_zero().time_since_epoch());
    EXPECT_EQ(patch.sent, lit_.front().time_since_epoch());
    forget_signals();
  }
}

TEST_F(TriggerTest, LinesTellEveryEventInOrderAndTheSerialOneThoseWithACode) {
  const auto record = present(trial(true, true));
  EXPECT_THAT(
      events_of(record, "socket"),
      ElementsAre("trial_start", "auditory_zero", "visual_zero", "stimulus_end", "response"));
  EXPECT_THAT(events_of(record, "serial"), ElementsAre("auditory_zero", "visual_zero"));
  EXPECT_EQ(the(record, "serial", "visual_zero").code, 1);
  EXPECT_EQ(the(record, "serial", "auditory_zero").code, 2);
  EXPECT_EQ(the(record, "socket", "visual_zero").code, std::nullopt);
  EXPECT_TRUE(settled_);
  EXPECT_FALSE(record.flagged);
  for (const auto& signal : socket_.signals) {
    EXPECT_EQ(signal.trial, 4);
    EXPECT_EQ(signal.condition, "AV");
  }
}

TEST_F(TriggerTest, AreStampedAsTheLineReports) {
  const auto record = present(trial(true, true));
  const auto visual = the(record, "serial", "visual_zero");
  EXPECT_EQ(visual.planned, cues_->visual_zero().time_since_epoch());  // shown as planned
  EXPECT_EQ(visual.sent, visual.planned + 30us);
  EXPECT_EQ(visual.uncertainty, Duration{20us});
  EXPECT_EQ(visual.source, "write_returned");
}

TEST_F(TriggerTest, AuditoryZeroIsToldAheadForTheInstantAtWhichItIsHeard) {
  for (const auto offset : {Duration{0}, Duration{150ms}, Duration{-450ms}}) {
    Instant posted;
    const auto made = trial(true, true, offset);
    display_.observe([&](const Screen&, const Presentation& shown) {
      if (socket_.signals.size() < 2) posted = shown.onset;
    });
    const auto record = present(made);
    const auto heard = the(record, "serial", "auditory_zero").planned;
    EXPECT_EQ(heard, cues_->auditory_zero().time_since_epoch());
    EXPECT_EQ(heard, *record.onsets.at(1).reported);
    EXPECT_LT(posted, cues_->auditory_zero());
    forget_signals();
  }
}

/// Begins every sound 30 ms late.
class LateAudio final : public AudioOutput {
 public:
  explicit LateAudio(const Clock& clock) : audio_{clock, Hertz{48'000}} {}

  void schedule(const Sound& sound, Instant onset) override {
    audio_.schedule(sound, onset + 30ms);
  }

  void move(Instant onset) override { audio_.move(onset + 30ms); }

  void stop() override { audio_.stop(); }

  [[nodiscard]] Playback playback() override { return audio_.playback(); }

  [[nodiscard]] Duration lead_time() const override { return {}; }

  [[nodiscard]] Hertz rate() const override { return audio_.rate(); }

  [[nodiscard]] std::string kind() const override { return "late"; }

  [[nodiscard]] std::string description() const override { return "late"; }

  [[nodiscard]] std::string_view time_source() const override { return "predicted"; }

 private:
  SimulatedAudio audio_;
};

TEST_F(TriggerTest, AuditoryZeroAndClickAreAsLateAsTheSound) {
  LateAudio late{clock_};
  const auto made = trial(true, true);
  auto cues = cues_for(made);
  const auto record = present(made, cues, late);
  const auto planned = cues.auditory_zero().time_since_epoch();
  EXPECT_EQ(the(record, "serial", "auditory_zero").planned, planned + 30ms);
  const auto click = the(record, "click", "auditory_zero");
  EXPECT_EQ(click.planned, planned);
  EXPECT_EQ(click.sent, planned + 30ms);
}

TEST_F(TriggerTest, ClickOfASoundThatIsNotPlayedIsNotSent) {
  SilentAudio none{clock_};
  const auto made = trial(true, true);
  auto cues = cues_for(made);
  const auto record = present(made, cues, none);
  EXPECT_EQ(the(record, "click", "auditory_zero").sent, std::nullopt);
  EXPECT_EQ(the(record, "click", "auditory_zero").source, "none");
}

TEST_F(TriggerTest, WhatIsNotThereIsNotTold) {
  const auto silent = present(trial(false, true));
  EXPECT_THAT(events_of(silent, "click"), IsEmpty());
  EXPECT_THAT(events_of(silent, "serial"), ElementsAre("visual_zero"));
  forget_signals();
  const auto unseen = present(trial(true, false));
  EXPECT_THAT(events_of(unseen, "serial"), ElementsAre("auditory_zero"));
}

TEST_F(TriggerTest, LostLineIsAnEventAndFlagsTheTrial) {
  serial_.lost = true;
  const auto record = present(trial(true, true));
  EXPECT_TRUE(settled_);
  EXPECT_TRUE(record.flagged);
  ASSERT_EQ(record.events.size(), 1U);
  EXPECT_EQ(record.events.at(0).kind, "trigger_lost");
  EXPECT_EQ(record.events.at(0).detail, "a line: not sent: auditory_zero, visual_zero");
  EXPECT_EQ(the(record, "serial", "visual_zero").sent, std::nullopt);
  EXPECT_EQ(the(record, "serial", "visual_zero").source, "none");
  EXPECT_TRUE(the(record, "socket", "visual_zero").sent.has_value());
}

TEST_F(TriggerTest, LineThatDoesNotReportCountsAsLost) {
  socket_.silent = true;
  const auto record = present(trial(true, true));
  EXPECT_FALSE(settled_);
  EXPECT_THAT(record.events.at(0).detail, HasSubstr("not sent: trial_start, auditory_zero"));
}

TEST_F(TriggerTest, NothingIsAllocatedWhileTheStimulusIsOnTheScreen) {
  const auto made = trial(true, true);
  std::vector<std::size_t> allocations;
  allocations.reserve(1000);
  display_.observe([&](const Screen& screen, const Presentation&) {
    if (!screen.fixation) allocations.push_back(allocations_of_this_thread());
  });
  const auto record = present(made);
  ASSERT_GT(allocations.size(), 100U);
  EXPECT_EQ(allocations.at(101), allocations.front());
  EXPECT_FALSE(record.triggers.empty());
}

}  // namespace
}  // namespace bimodal::runner

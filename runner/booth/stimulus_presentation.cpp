#include "runner/booth/stimulus_presentation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "runner/booth/clock_records.hpp"
#include "runner/booth/keystroke_record.hpp"
#include "runner/booth/patch.hpp"
#include "runner/booth/refresh_watch.hpp"
#include "runner/booth/shown_refreshes.hpp"
#include "runner/devices/device_error.hpp"
#include "stimuli/base/milliseconds.hpp"

namespace bimodal::runner {

namespace {

using namespace std::chrono_literals;

Duration since_zero(Instant at) {
  return at.time_since_epoch();
}

/// A sound that begins this much later than planned flags its trial.
constexpr Duration kSoundTolerance = 2ms;

/// How long to wait for the device's word on when the sound began.
constexpr Duration kReportPatience = 500ms;

Picture picture_of(const Film& film, std::size_t number) {
  const auto& image = *film.pictures[number];
  return {.width = image.width, .height = image.height, .pixels = image.pixels};
}

/// How long nothing is heard after the sound has begun.
Duration silence_of(const Sound& sound) {
  const double seconds = static_cast<double>(sound.silent_head) / sound.rate.count();
  return Duration{std::llround(seconds * 1e9)};
}

constexpr const char* kSoundJump = "sound_jump";

void note_jump(TrialRecord& record, Instant now) {
  record.events.push_back(
      {.at = since_zero(now),
       .kind = kSoundJump,
       .detail = "the sound's clock jumped: samples came late by whole buffers"});
  record.flagged = true;
}

class StimulusLoop {
 public:
  StimulusLoop(const Booth& booth,
               const PreparedTrial& trial,
               CueSheet& cues,
               TrialMachine& machine,
               TriggerLog& triggers,
               TrialRecord& record)
      : booth_{booth},
        trial_{trial},
        cues_{cues},
        machine_{machine},
        triggers_{triggers},
        record_{record},
        shown_{trial, record.refreshes} {}

  void run() {
    const auto jumps = clock_jumps();
    const auto period = booth_.display.refresh().period;
    if (trial_.sound) booth_.audio.schedule(*trial_.sound, device_onset());
    while (true) {
      follow_screen();
      const auto due = next_refresh();
      if (due >= cues_.end()) break;
      show(due);
      triggers_.follow_sound(trial_, cues_, booth_);
      if (trial_.sound) static_cast<void>(booth_.audio.playback());  // its clock is followed
      take_strokes();
    }
    record_.stimulus_start = since_zero(cues_.first_refresh());
    record_.stimulus_end = since_zero(cues_.end());
    triggers_.send(protocols::TriggerEvent::StimulusEnd, cues_.end());
    shown_.finish(cues_, booth_.display.refresh().period);
    if (trial_.frames > 0) report_picture();
    if (trial_.sound) report_sound();
    report_offset();
    if (trial_.sound && clock_jumps() != jumps) note_jump(record_, booth_.clock.now());
    if (is_another_period(booth_.display.refresh().period, period)) {
      note("refresh_changed", "the screen has another refresh rate than before");
    }
    note_clocks(booth_, record_);
  }

 private:
  /// May ask to stop, which is answered after the stimulus, or already be the answer.
  void take_strokes() {
    if (!onset_passed_ && booth_.clock.now() >= earlier_zero()) {
      onset_passed_ = true;
      static_cast<void>(machine_.on(OnsetPassed{earlier_zero()}));
    }
    for (const auto& stroke : booth_.keyboard.poll()) {
      if (machine_.takes_answer()) record_.keystrokes.push_back(record_of(stroke));
      for (const auto& command : machine_.on(stroke)) {
        const auto* const answer = std::get_if<NoteEarlyAnswer>(&command);
        if (answer != nullptr) triggers_.send(protocols::TriggerEvent::Response, answer->at);
      }
    }
  }

  /// When time zero is to be seen or heard, whichever comes first.
  [[nodiscard]] Instant earlier_zero() const {
    const auto seen = trial_.frames > 0 ? cues_.visual_zero() : cues_.auditory_zero();
    const auto heard = trial_.sound ? cues_.auditory_zero() : cues_.visual_zero();
    return std::min(seen, heard) + booth_.reference.line_after;
  }

  /// Takes picture and sound along with the screen as long as the sound can still be moved, or
  /// without a sound until time zero was shown.
  void follow_screen() {
    const bool begins_later = !trial_.sound || booth_.clock.now() + booth_.audio.lead_time() <
                                                   device_onset() + silent_head_;
    settled_ = settled_ || !begins_later || shown_.zero();
    if (settled_) return;
    cues_.follow(booth_.display.refresh());
    if (trial_.sound) booth_.audio.move(device_onset());
  }

  /// When the sound's device is to say that the first sample is heard.
  [[nodiscard]] Instant device_onset() const {
    return cues_.sound_onset() + booth_.reference.line_after - booth_.reference.sound_after;
  }

  /// The first refresh that can still be met.
  [[nodiscard]] Instant next_refresh() const {
    const auto grid = booth_.display.refresh();
    const auto reachable = refresh_not_before(grid, booth_.clock.now() + Duration{1});
    if (!last_shown_) return reachable;
    return std::max(reachable, nearest_refresh(grid, *last_shown_) + grid.period);
  }

  void show(Instant due) {
    const auto frame = trial_.frames > 0 ? cues_.frame_at(due) : std::nullopt;
    choose_picture(due, frame);
    screen_.at_zero = zero_cue_.is_next(due, frame, booth_.display.refresh().period);
    const auto presented = booth_.display.present(screen_, due);
    if (screen_.at_zero) pass_zero(presented);
    if (frame) {
      const auto period = booth_.display.refresh().period;
      shown_.add(*frame, due, presented, cues_.first_refresh(), period);
    }
    last_shown_ = presented.onset;
  }

  /// The fixation mark before the first frame, and the last frame while the sound goes on after it.
  void choose_picture(Instant due, std::optional<std::int64_t> frame) {
    const bool before = due < cues_.visual_zero() && !frame;
    screen_.fixation = trial_.frames == 0 || before;
    screen_.picture = nullptr;
    if (!trial_.film || screen_.fixation) return;
    const auto shown = frame.value_or(trial_.frames - 1);
    const auto number = trial_.film->picture_of_frame.at(static_cast<std::size_t>(shown));
    if (number == Film::kBlank) return;
    picture_ = picture_of(*trial_.film, number);
    screen_.picture = &picture_;
  }

  void pass_zero(const Presentation& presented) {
    triggers_.zero_shown(presented, trial_, cues_);
    zero_cue_.pass();
    screen_.at_zero = false;
  }

  void report_picture() {
    OnsetRecord onset{.modality = "visual",
                      .planned = since_zero(cues_.visual_zero() + booth_.reference.line_after),
                      .source = std::string{name(shown_.source())}};
    if (const auto zero = shown_.zero()) {
      onset.reported = since_zero(*zero + booth_.reference.line_after);
    }
    record_.onsets.push_back(onset);
    if (!shown_.zero()) note("visual_unreported", "nothing was shown of time zero or after it");
    note_refreshes("late_frame", shown_.missed(), "late");
    note_refreshes("early_frame", shown_.early(), "early");
    if (booth_.display.time_source() != TimeSource::Predicted) {
      note_refreshes("frame_unreported", shown_.unreported(), "not reported by the display");
      if (shown_.unreported() > 0 && shown_.unreported() == shown_.count()) {
        note("screen_silent",
             "the display reported nothing: it may be asleep, or the window hidden");
      }
    }
  }

  [[nodiscard]] int clock_jumps() const {
    const auto clock = booth_.audio.clock();
    return clock ? clock->jumps : 0;
  }

  void note_refreshes(const char* kind, int count, std::string_view how) {
    if (count == 0) return;
    note(kind, fmt::format("{} {} {}", count, count == 1 ? "refresh was" : "refreshes were", how));
  }

  void report_sound() {
    auto playback = booth_.audio.playback();
    const Instant latest = cues_.end() + kReportPatience;
    while (!playback.finished && booth_.clock.now() < latest) {
      static_cast<void>(booth_.display.present(screen_, booth_.clock.now()));
      playback = booth_.audio.playback();
    }
    OnsetRecord onset{.modality = "auditory",
                      .planned = since_zero(cues_.auditory_zero() + booth_.reference.line_after),
                      .source = std::string{playback.source}};
    if (playback.onset) {
      onset.reported =
          since_zero(*playback.onset + booth_.reference.sound_after + trial_.layout.sound_lead);
      const auto lateness = *playback.onset - device_onset();
      if (std::chrono::abs(lateness) > kSoundTolerance) {
        note("late_sound", fmt::format("{:+.2f} ms against the plan", milliseconds(lateness)));
      }
    }
    if (playback.lost) {
      throw SoundLost{
          "the sound device was lost during a trial, which is not stored; check the "
          "device and the sound server"};
    }
    record_.onsets.push_back(onset);
    triggers_.click_heard(onset);
    if (!playback.onset && booth_.audio.kind() != "none") {
      note("sound_unreported", "the device did not report the sound's onset");
    }
    if (playback.underflows > 0) {
      note("underflow", fmt::format("{} during the sound", playback.underflows));
    }
    if (!playback.finished) note("sound_unfinished", "the device did not report the sound's end");
  }

  /// Both onsets as they were reported, against the offset that was meant.
  void report_offset() {
    const auto reported = [&](std::string_view modality) -> std::optional<Duration> {
      const auto found = std::ranges::find(record_.onsets, modality, &OnsetRecord::modality);
      return found == record_.onsets.end() ? std::nullopt : found->reported;
    };
    const auto heard = reported("auditory");
    const auto seen = reported("visual");
    if (!heard || !seen) return;
    const auto off = *heard - *seen - trial_.layout.av_offset;
    if (std::chrono::abs(off) <= trial_.offset_tolerance) return;
    note("av_offset", fmt::format("{:+.2f} ms from the intended one", milliseconds(off)));
  }

  void note(std::string kind, std::string detail) {
    record_.events.push_back({.at = since_zero(booth_.clock.now()),
                              .kind = std::move(kind),
                              .detail = std::move(detail)});
    record_.flagged = true;
  }

  const Booth& booth_;
  const PreparedTrial& trial_;
  CueSheet& cues_;
  TrialMachine& machine_;
  TriggerLog& triggers_;
  TrialRecord& record_;
  ShownRefreshes shown_;
  ZeroCue zero_cue_{trial_, cues_};
  Duration silent_head_ = trial_.sound ? silence_of(*trial_.sound) : Duration{};
  bool onset_passed_ = false;
  bool settled_ = false;  ///< time zero stays where it is
  Screen screen_;
  Picture picture_;
  std::optional<Instant> last_shown_;
};

}  // namespace

void review_sound(const Booth& booth, TrialRecord& record) {
  const auto latest = booth.clock.now() + kReportPatience;
  auto playback = booth.audio.playback();
  while (!playback.known && booth.clock.now() < latest) {
    booth.display.wait(booth.clock.now() + 1ms);
    playback = booth.audio.playback();
  }
  const bool is_noted =
      std::ranges::find(record.events, kSoundJump, &EventRecord::kind) != record.events.end();
  if (playback.jumped && !is_noted) note_jump(record, booth.clock.now());
}

void present_stimulus(const Booth& booth,
                      const PreparedTrial& trial,
                      CueSheet& cues,
                      TrialMachine& machine,
                      TriggerLog& triggers,
                      TrialRecord& record) {
  StimulusLoop{booth, trial, cues, machine, triggers, record}.run();
}

}  // namespace bimodal::runner

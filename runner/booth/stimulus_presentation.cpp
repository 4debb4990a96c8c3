#include "runner/booth/stimulus_presentation.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "runner/booth/patch.hpp"
#include "runner/devices/device_error.hpp"

namespace bimodal::runner {

namespace {

using namespace std::chrono_literals;

Duration since_zero(Instant at) {
  return at.time_since_epoch();
}

double milliseconds(Duration duration) {
  return std::chrono::duration<double, std::milli>{duration}.count();
}

/// A sound that begins this much later than planned flags its trial.
constexpr Duration kSoundTolerance = 2ms;

/// How long to wait for the device's word on when the sound began.
constexpr Duration kReportPatience = 500ms;

Picture picture_of(const Film& film, std::size_t number) {
  const auto& image = *film.pictures[number];
  return {.width = image.width, .height = image.height, .pixels = image.pixels};
}

/// The frame of the media file that a frame of a film shows; -1 where it is blank.
std::int64_t source_frame(const Film& film, std::int64_t frame) {
  const auto number = film.picture_of_frame[static_cast<std::size_t>(frame)];
  return number == Film::kBlank ? -1 : film.source_frame_of_picture[number];
}

class StimulusLoop {
 public:
  StimulusLoop(const Booth& booth,
               const PreparedTrial& trial,
               const CueSheet& cues,
               TrialMachine& machine,
               TriggerLog& triggers,
               TrialRecord& record)
      : booth_{booth},
        trial_{trial},
        cues_{cues},
        machine_{machine},
        triggers_{triggers},
        record_{record} {
    const auto expected = static_cast<std::size_t>(trial.frames) + 8;
    record_.refreshes.frame.reserve(expected);
    if (shows_video_) record_.refreshes.source_frame.reserve(expected);
    record_.refreshes.planned.reserve(expected);
    record_.refreshes.shown.reserve(expected);
    record_.stimulus_start = since_zero(cues.first_refresh());
    record_.stimulus_end = since_zero(cues.end());
  }

  void run() {
    if (trial_.sound) booth_.audio.schedule(*trial_.sound, cues_.sound_onset());
    await_first_refresh();
    std::int64_t index = 0;
    while (cues_.refresh(index) < cues_.end()) {
      const Instant shown = show(index);
      triggers_.follow_sound(trial_, cues_, booth_);
      for (const auto& stroke : booth_.keyboard.poll()) {
        static_cast<void>(machine_.on(stroke));  // may ask to stop; answered after the stimulus
      }
      index = cues_.refresh_after(index, shown);
    }
    triggers_.send(protocols::TriggerEvent::StimulusEnd, cues_.end());
    report_picture();
    if (trial_.sound) report_sound();
  }

 private:
  /// The fixation mark stays, drawn at every refresh so that the screen keeps its rhythm.
  void await_first_refresh() {
    const Duration period = booth_.display.refresh().period;
    screen_.fixation = true;
    while (booth_.clock.now() + 3 * period / 2 < cues_.first_refresh()) {
      static_cast<void>(booth_.display.present(screen_, booth_.clock.now()));
      triggers_.follow_sound(trial_, cues_, booth_);
      for (const auto& stroke : booth_.keyboard.poll()) static_cast<void>(machine_.on(stroke));
    }
  }

  Instant show(std::int64_t index) {
    const auto due = cues_.frame_at(index);
    const bool shows_frame = trial_.frames > 0 && due.has_value();
    const std::int64_t frame = due.value_or(trial_.frames - 1);
    screen_.fixation = trial_.frames == 0;
    screen_.picture = nullptr;
    if (trial_.film && trial_.frames > 0) {
      const auto number = trial_.film->picture_of_frame.at(static_cast<std::size_t>(frame));
      if (number != Film::kBlank) {
        picture_ = picture_of(*trial_.film, number);
        screen_.picture = &picture_;
      }
    }
    const Instant planned = cues_.refresh(index);
    screen_.at_zero = zero_cue_.is_next(index, frame);
    const auto presented = booth_.display.present(screen_, planned);
    if (screen_.at_zero) pass_zero(presented);
    if (shows_frame) {
      const Duration half = booth_.display.refresh().period / 2;
      if (presented.lateness > half) ++late_;
      if (presented.lateness < -half) ++early_;
      record_.refreshes.frame.push_back(frame);
      if (shows_video_) {
        record_.refreshes.source_frame.push_back(source_frame(*trial_.film, frame));
      }
      record_.refreshes.planned.push_back(since_zero(planned));
      record_.refreshes.shown.push_back(since_zero(presented.onset));
      if (!zero_ && frame >= zero_frame_) zero_ = presented;
      if (zero_ && !zero_since_)
        zero_since_ = frame_time(trial_.layout, trial_.drawing_rate, frame);
    }
    return presented.onset;
  }

  void pass_zero(const Presentation& presented) {
    triggers_.zero_shown(presented, trial_, cues_);
    zero_cue_.pass();
    screen_.at_zero = false;
  }

  void report_picture() {
    if (trial_.frames == 0) return;
    OnsetRecord onset{.modality = "visual",
                      .planned = since_zero(cues_.visual_zero()),
                      .source = std::string{name(zero_ ? zero_->source : TimeSource::Predicted)}};
    // If the frame of time zero was left out, the first one after it tells when it would have been.
    if (zero_) onset.reported = since_zero(zero_->onset - *zero_since_);
    record_.onsets.push_back(onset);
    note_refreshes("late_frame", late_, "late");
    note_refreshes("early_frame", early_, "early");
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
                      .planned = since_zero(cues_.auditory_zero()),
                      .source = std::string{playback.source}};
    if (playback.onset) {
      onset.reported = since_zero(*playback.onset + trial_.layout.sound_lead);
      const auto lateness = *playback.onset - cues_.sound_onset();
      if (std::chrono::abs(lateness) > kSoundTolerance) {
        note("late_sound", fmt::format("{:+.2f} ms against the plan", milliseconds(lateness)));
      }
    }
    if (playback.lost) {
      throw DeviceError{
          "the sound device was lost during a trial, which is not stored; check it and begin the "
          "session again by --again"};
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

  void note(std::string kind, std::string detail) {
    record_.events.push_back({.at = since_zero(booth_.clock.now()),
                              .kind = std::move(kind),
                              .detail = std::move(detail)});
    record_.flagged = true;
  }

  const Booth& booth_;
  const PreparedTrial& trial_;
  const CueSheet& cues_;
  TrialMachine& machine_;
  TriggerLog& triggers_;
  TrialRecord& record_;
  bool shows_video_ = trial_.film && !trial_.film->source_frame_of_picture.empty();
  ZeroCue zero_cue_{trial_, cues_};
  Screen screen_;
  Picture picture_;
  std::optional<Presentation> zero_;    ///< of the first frame not before time zero
  std::optional<Duration> zero_since_;  ///< which time of the recording that frame shows
  std::int64_t zero_frame_ = lead_frames(trial_.layout, trial_.drawing_rate);
  int late_ = 0;  ///< frames more than half a refresh off
  int early_ = 0;
};

}  // namespace

void present_stimulus(const Booth& booth,
                      const PreparedTrial& trial,
                      const CueSheet& cues,
                      TrialMachine& machine,
                      TriggerLog& triggers,
                      TrialRecord& record) {
  StimulusLoop{booth, trial, cues, machine, triggers, record}.run();
}

}  // namespace bimodal::runner

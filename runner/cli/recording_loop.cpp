#include "runner/cli/recording_loop.hpp"

#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "runner/cli/recording_screen.hpp"
#include "runner/cli/session_setup.hpp"
#include "stimuli/audio/speech_detector.hpp"
#include "stimuli/audio/take_check.hpp"

namespace bimodal::runner {

namespace {

using Phase = RecordingMachine::Phase;

/// A louder room is not quiet, whatever makes the noise.
constexpr Decibels kLoudestRoom{-40.0};

template <typename... Handlers>
struct Match : Handlers... {
  using Handlers::operator()...;
};

template <typename... Handlers>
Match(Handlers...) -> Match<Handlers...>;  // needed by clang 14, and so by clang-tidy 14

std::vector<RecordingSlot> machine_slots(const std::vector<WordSlot>& slots) {
  std::vector<RecordingSlot> made;
  for (const auto& slot : slots) made.push_back({slot.word, !slot.file.empty()});
  return made;
}

class RecordingLoop {
 public:
  RecordingLoop(const RecordingParts& parts, std::vector<WordSlot> slots)
      : parts_{parts}, machine_{machine_slots(slots), parts.rules}, slots_{std::move(slots)} {}

  RecordingOutcome run() {
    while (machine_.phase() != Phase::Ended && !parts_.interrupted()) {
      prompt_simulated_talker();
      present();
      for (const auto& stroke : parts_.keyboard.poll()) tell(stroke);
      listen();
      tell(Moment{parts_.clock.now(), silence()});
    }
    return {machine_.done(), machine_.done() == slots_.size()};
  }

 private:
  void present() {
    static_cast<void>(
        parts_.display.present(recording_screen(machine_, last_take_), parts_.clock.now()));
  }

  void tell(const RecordingEvent& event) {
    for (const auto& command : machine_.on(event)) perform(command);
  }

  void perform(const RecordingCommand& command) {
    std::visit(Match{[this](const BeginCapture&) { begin_capture(); },
                     [this](const EndRoom&) { judge_room(); },
                     [this](const EndTake& end) { judge_take(slots_[end.slot]); },
                     [this](const DropCapture&) { parts_.input.stop(); },
                     [this](const KeepTake& keep) { keep_take(slots_[keep.slot]); },
                     [this](const RejectTake& reject) { reject_take(slots_[reject.slot]); },
                     [](const EndRecording&) {}},
               command);
  }

  void begin_capture() {
    samples_.clear();
    detector_.reset();
    if (machine_.phase() == Phase::Recording) detector_.emplace(parts_.input.rate(), room_);
    started_utc_ = utc_now();
    parts_.input.start();
  }

  void listen() {
    const auto before = samples_.size();
    parts_.input.collect(samples_);
    if (detector_) detector_->feed(std::span{samples_}.subspan(before));
  }

  [[nodiscard]] std::optional<Duration> silence() const {
    return detector_ ? detector_->silence() : std::nullopt;
  }

  /// What was captured; the capture is over.
  Clip captured() {
    parts_.input.collect(samples_);
    parts_.input.stop();
    detector_.reset();
    return {parts_.input.rate(), std::exchange(samples_, {})};
  }

  [[nodiscard]] TakeSource source() const {
    return {started_utc_, parts_.input.description(), parts_.simulated};
  }

  void judge_room() {
    const auto room = captured();
    room_ = room_level(room);
    SpeechDetector detector{room.rate, room_};
    detector.feed(room.samples);
    parts_.folder.add_room(room, room_, source());
    const bool is_quiet = room_ <= kLoudestRoom && !detector.speech();
    parts_.announce(
        fmt::format("room: {:.1f} dB FS{}", room_.count(), is_quiet ? "" : ", not quiet"));
    tell(RoomJudged{parts_.clock.now(), is_quiet});
  }

  void judge_take(WordSlot& slot) {
    const auto take = captured();
    const auto lost = parts_.input.lost();
    const auto measures = measure_take(take, room_);
    const auto faults = faults_of(measures, lost);
    last_take_ = ShownTake{measures, faults};
    if (!measures.speech) {
      parts_.announce(fmt::format("{}: nothing was heard", slot.word));
      tell(TakeJudged{.at = parts_.clock.now(), .good = false, .kept = false});
      return;
    }
    newest_ = parts_.folder.add(slot.word, take, measures, lost, faults, source(), slot.file);
    announce(measures, faults);
    if (faults.empty()) slot.file = newest_;
    tell(TakeJudged{.at = parts_.clock.now(), .good = faults.empty(), .kept = true});
  }

  void announce(const TakeMeasures& measures, const std::vector<TakeFault>& faults) {
    auto verdict = std::string{faults.empty() ? "good" : "doubtful"};
    for (const auto fault : faults) verdict += fmt::format(", {}", name(fault));
    parts_.announce(
        fmt::format("{}: {}: speech {:.1f} dB FS, peak {:.1f}, {:.1f} dB above the room",
                    newest_,
                    verdict,
                    measures.level.count(),
                    measures.peak.count(),
                    measures.snr.count()));
  }

  void keep_take(WordSlot& slot) {
    parts_.folder.keep(newest_, slot.file);
    slot.file = newest_;
    parts_.announce(fmt::format("{}: kept", newest_));
  }

  void reject_take(WordSlot& slot) {
    parts_.folder.reject(slot.file);
    parts_.announce(fmt::format("{}: rejected", slot.file));
    slot.file.clear();
  }

  /// Tells a simulated talker, once, what to press where the machine waits.
  void prompt_simulated_talker() {
    if (!parts_.answers_itself) return;
    const auto place = std::pair{machine_.phase(), machine_.slot()};
    if (!machine_.awaits_key()) prompted_.reset();
    if (!machine_.awaits_key() || prompted_ == place) return;
    prompted_ = place;
    const bool gives_up =
        machine_.phase() == Phase::Doubt && machine_.attempts() >= parts_.rules.attempts;
    const bool goes_on = machine_.phase() == Phase::RoomDoubt;
    parts_.keyboard.expect(gives_up ? "s" : goes_on ? "k" : "", parts_.clock.now());
  }

  const RecordingParts& parts_;
  RecordingMachine machine_;
  std::vector<WordSlot> slots_;
  Decibels room_;
  std::vector<float> samples_;              ///< of the present capture
  std::optional<SpeechDetector> detector_;  ///< while a take is captured
  std::string started_utc_;
  std::optional<ShownTake> last_take_;
  std::string newest_;  ///< file of the newest take
  std::optional<std::pair<Phase, std::size_t>>
      prompted_;  ///< where a talker was told what to press
};

}  // namespace

RecordingOutcome record_words(const RecordingParts& parts, std::vector<WordSlot> slots) {
  return RecordingLoop{parts, std::move(slots)}.run();
}

}  // namespace bimodal::runner

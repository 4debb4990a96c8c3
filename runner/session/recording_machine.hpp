#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "runner/session/keystroke.hpp"
#include "stimuli/base/quantity.hpp"

namespace bimodal::runner {

/// One word to be recorded.
struct RecordingSlot {
  std::string text;   ///< what is to be said
  bool done = false;  ///< it has a take that counts
};

struct RecordingRules {
  bool automatic = false;                             ///< each word begins without a key
  Duration room = std::chrono::seconds{2};            ///< of silence at the beginning
  Duration arming = std::chrono::milliseconds{300};   ///< from the key to the red dot: its click
  Duration reading = std::chrono::seconds{1};         ///< a word is shown so long, if automatic
  Duration silence = std::chrono::milliseconds{600};  ///< after speech: the word is over
  Duration limit = std::chrono::seconds{5};           ///< the longest take
  Duration praise = std::chrono::milliseconds{800};   ///< a good judgement stays so long
  Duration reproof = std::chrono::seconds{3};         ///< a bad one, if automatic
  int attempts = 3;  ///< doubtful takes of one word in a row; then even --auto waits for a key
};

/// Time passes. To be told at every refresh.
struct Moment {
  Instant at;
  std::optional<Duration> silence{};  ///< since speech ended in the present take; absent: no speech
};

/// What became of the captured room.
struct RoomJudged {
  Instant at;
  bool quiet = true;
};

/// What became of the captured take. It has been stored, unless nothing was said.
struct TakeJudged {
  Instant at;
  bool good = true;
  bool kept = true;  ///< false: there was nothing to store
};

using RecordingEvent = std::variant<Moment, Keystroke, RoomJudged, TakeJudged>;

struct BeginCapture {};

/// Answered by RoomJudged.
struct EndRoom {};

/// Answered by TakeJudged.
struct EndTake {
  std::size_t slot = 0;
};

/// Forget what is being captured.
struct DropCapture {};

/// The newest take of the slot counts after all, although it was doubtful.
struct KeepTake {
  std::size_t slot = 0;
};

/// The take of the slot that counted does so no longer.
struct RejectTake {
  std::size_t slot = 0;
};

struct EndRecording {
  bool complete = false;  ///< every slot is done
};

using RecordingCommand =
    std::variant<BeginCapture, EndRoom, EndTake, DropCapture, KeepTake, RejectTake, EndRecording>;

/// Leads a talker through a list of words. A pure state machine: the clock is in the events, the
/// devices and files are in the commands.
///
/// Space or Enter begins the room's silence, each word, and ends a word by hand; Backspace or R
/// says the last take (or the one being made) over again, Left goes back a word, S passes over one,
/// K keeps a doubtful take; Escape (or closing the window) asks whether to stop, and again stops.
/// A take that counts is replaced only when another good one is there. Held keys do nothing twice.
class RecordingMachine {
 public:
  /// At least one slot. Begins with the first that is not done.
  RecordingMachine(std::vector<RecordingSlot> slots, const RecordingRules& rules);

  [[nodiscard]] std::vector<RecordingCommand> on(const RecordingEvent& event);

  enum class Phase {
    Welcome,  ///< waits for a key
    Room,     ///< captures the room
    RoomJudging,
    RoomDoubt,  ///< it was not quiet: again (Space) or go on (K)
    Ready,      ///< shows the word
    Arming,     ///< the click of the key dies away
    Recording,  ///< captures: the red dot
    TakeJudging,
    Praise,      ///< the take is good
    Doubt,       ///< the take is doubtful: again (Space), keep (K), pass over (S)
    Confirming,  ///< stop?
    Complete,    ///< all is done; waits for a key
    Ended
  };

  [[nodiscard]] Phase phase() const { return phase_; }

  /// Whether it stands still until a key is pressed.
  [[nodiscard]] bool awaits_key() const;

  [[nodiscard]] const std::vector<RecordingSlot>& slots() const { return slots_; }

  /// The slot that is shown.
  [[nodiscard]] std::size_t slot() const { return slot_; }

  [[nodiscard]] std::size_t done() const;

  /// Whether the doubtful take that is shown can be kept.
  [[nodiscard]] bool can_keep() const { return phase_ == Phase::Doubt && can_keep_; }

  /// Doubtful takes of the present slot in a row.
  [[nodiscard]] int attempts() const { return attempts_; }

 private:
  using Commands = std::vector<RecordingCommand>;

  Commands on_moment(const Moment& moment);
  Commands on_key(const Keystroke& stroke);
  Commands on_take(const TakeJudged& judged);
  Commands on_confirming(const Keystroke& stroke);
  Commands on_ready(const Keystroke& stroke);
  Commands on_recording(const Keystroke& stroke);
  Commands on_doubt(const Keystroke& stroke);
  Commands ask_to_stop(Instant at);
  Commands again(Instant at);
  Commands begin_room(Instant at);
  void pass_over(Instant at);
  void enter(Phase phase, Instant at);
  void show(std::size_t slot, Instant at);
  void go_on(Instant at);
  [[nodiscard]] bool is_held_key(const Keystroke& stroke);

  std::vector<RecordingSlot> slots_;
  std::vector<bool> passed_over_;
  RecordingRules rules_;
  Phase phase_ = Phase::Welcome;
  Phase interrupted_ = Phase::Welcome;  ///< where Confirming goes back to
  Instant since_;                       ///< when the phase began
  std::size_t slot_ = 0;
  std::optional<std::size_t> last_;  ///< slot of the last take that was made to count
  int attempts_ = 0;
  bool can_keep_ = false;  ///< there is a doubtful take
  std::optional<Keystroke> last_stroke_;
};

}  // namespace bimodal::runner

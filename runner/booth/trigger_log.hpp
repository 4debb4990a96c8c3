#pragma once

#include <string_view>
#include <vector>

#include "protocols/model/triggers.hpp"
#include "runner/booth/booth.hpp"
#include "runner/preparation/trial_preparer.hpp"
#include "runner/session/cue_sheet.hpp"
#include "runner/store/records.hpp"

namespace bimodal::runner {

/// Tells other equipment what happens in a trial, and writes down what became of it. Telling
/// allocates nothing and never waits.
class TriggerLog {
 public:
  /// All are borrowed.
  TriggerLog(const protocols::Triggers& triggers, const std::vector<TriggerLine*>& lines)
      : triggers_{triggers}, lines_{lines} {}

  /// A trial begins; the log forgets the last one. `condition` is borrowed for the session.
  void begin(int trial, std::string_view condition);

  /// On all lines that tell of `event`, at `planned`, or at once if that is past.
  void send(protocols::TriggerEvent event, Instant planned);

  /// The refresh "at zero" has been shown: the patch has changed.
  void zero_shown(const Presentation& shown, const PreparedTrial& trial, const CueSheet& cues);

  /// To be called at every refresh: puts auditory zero on the lines when it is near, for the
  /// instant at which the device says that it is heard, or else for the planned one.
  void follow_sound(const PreparedTrial& trial, const CueSheet& cues, const Booth& booth);

  /// The sound is over: its click was heard at `reported`.
  void click_heard(const OnsetRecord& auditory);

  /// Whether everything that was sent has been reported.
  [[nodiscard]] bool settled();

  /// Adds the triggers to the trial; it is flagged, with an event, if some were not sent.
  void finish(TrialRecord& record, Instant now);

 private:
  struct Entry {
    TriggerRecord record;
    const TriggerLine* line = nullptr;  ///< whose report is awaited; null: it is complete
  };

  void take_reports();

  const protocols::Triggers& triggers_;
  const std::vector<TriggerLine*>& lines_;
  std::vector<Entry> entries_;
  int trial_ = 0;
  std::string_view condition_;
  bool sound_told_ = false;
};

}  // namespace bimodal::runner

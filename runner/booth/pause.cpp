#include "runner/booth/pause.hpp"

#include "runner/booth/participant_screens.hpp"
#include "runner/booth/stop_question.hpp"

namespace bimodal::runner {

PauseEnd hold_pause(const Booth& booth, Oversight& oversight) {
  const auto screen = pause_screen();
  oversight.note_pause();
  while (true) {
    if (oversight.stop_asked()) return PauseEnd::Stopped;
    if (!oversight.pause_asked()) break;
    static_cast<void>(booth.display.present(screen, booth.clock.now()));
    if (stop_is_meant(booth, oversight)) return PauseEnd::Stopped;
  }
  oversight.note_resumption();
  return PauseEnd::Resumed;
}

}  // namespace bimodal::runner

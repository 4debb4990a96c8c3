#include "runner/booth/pause.hpp"

#include <algorithm>

#include "runner/booth/participant_screens.hpp"
#include "runner/booth/stop_question.hpp"

namespace bimodal::runner {

PauseEnd hold_pause(const Booth& booth, Oversight& oversight) {
  const auto began = booth.clock.now();
  oversight.note_pause();
  while (true) {
    if (oversight.stop_asked()) return PauseEnd::Stopped;
    if (!oversight.pause_asked()) break;
    const bool on_the_spot = oversight.resumes_on_the_spot();
    const auto screen = on_the_spot ? trouble_screen() : pause_screen();
    static_cast<void>(booth.display.present(screen, booth.clock.now()));
    const auto strokes = booth.keyboard.poll();
    if (stop_is_meant(booth, oversight, strokes)) return PauseEnd::Stopped;
    const auto goes_on = [&](const Keystroke& stroke) {
      return stroke.key == Key::Enter && stroke.at > began;
    };
    if (on_the_spot && std::ranges::any_of(strokes, goes_on)) oversight.resume();
  }
  oversight.note_resumption();
  return PauseEnd::Resumed;
}

}  // namespace bimodal::runner

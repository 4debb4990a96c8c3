#include "runner/booth/stop_question.hpp"

#include <algorithm>

#include "runner/booth/participant_screens.hpp"

namespace bimodal::runner {

bool stop_is_meant(const Booth& booth, Oversight& oversight) {
  return stop_is_meant(booth, oversight, booth.keyboard.poll());
}

bool stop_is_meant(const Booth& booth, Oversight& oversight, std::span<const Keystroke> strokes) {
  if (std::ranges::none_of(strokes, asks_to_stop)) return false;
  const auto question = stop_question();
  while (true) {
    if (oversight.stop_asked()) return true;
    static_cast<void>(booth.display.present(question, booth.clock.now()));
    for (const auto& stroke : booth.keyboard.poll()) {
      if (asks_to_stop(stroke)) return true;
      if (stroke.key == Key::Enter) return false;
    }
  }
}

}  // namespace bimodal::runner

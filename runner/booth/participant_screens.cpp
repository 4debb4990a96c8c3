#include "runner/booth/participant_screens.hpp"

#include <utility>

namespace bimodal::runner {

namespace {

Screen screen_of(std::vector<Caption> captions) {
  Screen screen;
  screen.captions = std::move(captions);
  return screen;
}

}  // namespace

Screen page_screen(std::string text) {
  return screen_of({{.text = std::move(text), .centre_y = 0.42, .size = 0.035},
                    {.text = "Press Enter to go on.", .centre_y = 0.86, .size = 0.025}});
}

Screen answer_screen(const std::string& prompt, const std::string& answer) {
  return screen_of({{.text = prompt, .centre_y = 0.40, .size = 0.035},
                    {.text = answer + "_", .centre_y = 0.52, .size = 0.05},
                    {.text = "Enter: next word", .centre_y = 0.86, .size = 0.025}});
}

Screen stop_question() {
  return screen_of({{.text = "Stop the session here?\n\n"
                             "Escape: stop. What has been answered is kept.\nEnter: go on.",
                     .centre_y = 0.45,
                     .size = 0.035}});
}

Screen waiting_screen() {
  return screen_of({{.text = "One moment, please ...", .centre_y = 0.45, .size = 0.035}});
}

Screen pause_screen() {
  return screen_of({{.text = "A short pause. Please wait.", .centre_y = 0.45, .size = 0.035}});
}

}  // namespace bimodal::runner

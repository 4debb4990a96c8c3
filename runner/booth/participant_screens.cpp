#include "runner/booth/participant_screens.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

namespace bimodal::runner {

namespace {

Screen screen_of(std::vector<Caption> captions) {
  Screen screen;
  screen.captions = std::move(captions);
  return screen;
}

using Colour = std::array<float, 3>;

constexpr float kLightBackground = 0.4F;  ///< above it texts are black, as the display sets them
constexpr Colour kBlack{0.0F, 0.0F, 0.0F};
constexpr Colour kWhite{1.0F, 1.0F, 1.0F};

/// A part of the way from one colour to another.
Colour between(const Colour& from, const Colour& to, float part) {
  Colour mixed{};
  for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i] = from[i] + part * (to[i] - from[i]);
  return mixed;
}

/// Boxes are further from the ink than the background is, so that labels stay easy to read.
struct BoxColours {
  explicit BoxColours(std::uint32_t background) {
    const auto channel = [&](unsigned shift) {
      return static_cast<float>((background >> shift) & 0xffU) / 255.0F;
    };
    const Colour ground{channel(16), channel(8), channel(0)};
    const auto luma = 0.2126F * ground[0] + 0.7152F * ground[1] + 0.0722F * ground[2];
    const bool is_light = luma > kLightBackground;
    box = between(ground, is_light ? kWhite : kBlack, 0.4F);
    frame = is_light ? kBlack : kWhite;
  }

  Colour box{};
  Colour frame{};
};

Mark mark_of(const OptionBox& box, double margin, const Colour& colour) {
  return {.shape = Mark::Shape::Box,
          .centre_x = box.centre_x,
          .centre_y = box.centre_y,
          .width = box.width + margin,
          .height = box.height + margin,
          .colour = colour};
}

/// How the participant finds an option's key or button; empty: it has none.
std::string key_name(const protocols::Option& option) {
  if (!option.key.empty()) return option.key;
  return option.button != 0 ? fmt::format("button {}", option.button) : std::string{};
}

void add_option(const protocols::Option& option,
                const OptionBox& box,
                double label_size,
                Screen& screen) {
  const auto key = key_name(option);
  const double rise = key.empty() ? 0.0 : 0.14 * box.height;
  screen.captions.push_back({.text = option.label,
                             .centre_y = box.centre_y - rise,
                             .size = label_size,
                             .centre_x = box.centre_x});
  if (key.empty()) return;
  constexpr double kKeySize = 0.55;  // of the label's
  screen.captions.push_back({.text = key,
                             .centre_y = box.centre_y + 0.3 * box.height,
                             .size = kKeySize * label_size,
                             .centre_x = box.centre_x});
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

Screen choice_screen(const protocols::Response& response,
                     const OptionGrid& grid,
                     std::optional<std::size_t> chosen,
                     std::uint32_t background) {
  constexpr double kFrame = 0.012;
  const BoxColours colours{background};
  auto screen = screen_of({{.text = response.prompt, .centre_y = 0.24, .size = 0.035}});
  for (std::size_t i = 0; i < grid.boxes.size(); ++i) {
    if (chosen == i) screen.marks.push_back(mark_of(grid.boxes[i], kFrame, colours.frame));
    screen.marks.push_back(mark_of(grid.boxes[i], 0.0, colours.box));
    add_option(response.options.at(i), grid.boxes[i], grid.label_size, screen);
  }
  if (response.confirm && chosen) {
    screen.captions.push_back({.text = "Enter: this one", .centre_y = 0.88, .size = 0.025});
  }
  return screen;
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

Screen trouble_screen() {
  return screen_of({{.text = "The experiment pauses: something is wrong with the screen.\n"
                             "Please call the experimenter.",
                     .centre_y = 0.42,
                     .size = 0.035},
                    {.text = "Enter: go on", .centre_y = 0.86, .size = 0.025}});
}

Screen pause_screen() {
  return screen_of({{.text = "A short pause. Please wait.", .centre_y = 0.45, .size = 0.035}});
}

}  // namespace bimodal::runner

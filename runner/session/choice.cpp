#include "runner/session/choice.hpp"

#include <algorithm>
#include <cassert>

#include "stimuli/base/lower_case.hpp"

namespace bimodal::runner {

namespace {

constexpr int kLeftButton = 1;

template <typename Predicate>
std::optional<std::size_t> place_where(const std::vector<protocols::Option>& options,
                                       Predicate is_meant) {
  const auto found = std::ranges::find_if(options, is_meant);
  if (found == options.end()) return std::nullopt;
  return static_cast<std::size_t>(found - options.begin());
}

}  // namespace

std::optional<std::size_t> option_of(const ChoiceRules& rules, const Keystroke& stroke) {
  switch (stroke.key) {
    case Key::Text:
      return place_where(rules.options, [&](const protocols::Option& option) {
        return !option.key.empty() && lower_case(option.key) == lower_case(stroke.text);
      });
    case Key::Button:
      return place_where(rules.options, [&](const protocols::Option& option) {
        return option.button != 0 && option.button == stroke.button;
      });
    case Key::Pointer:
      if (stroke.button != kLeftButton) return std::nullopt;
      return box_at(rules.boxes, stroke.x, stroke.y);
    default:
      return std::nullopt;
  }
}

Keystroke stroke_for(const ChoiceRules& rules, std::size_t option) {
  const auto& meant = rules.options.at(option);
  if (!meant.key.empty()) return {.key = Key::Text, .text = meant.key};
  if (meant.button != 0) return {.key = Key::Button, .button = meant.button};
  assert(option < rules.boxes.size());
  const auto& box = rules.boxes.at(option);
  return {.key = Key::Pointer, .button = kLeftButton, .x = box.centre_x, .y = box.centre_y};
}

}  // namespace bimodal::runner

#include "runner/session/keystroke.hpp"

#include <fmt/format.h>

namespace bimodal::runner {

std::string label(const Keystroke& stroke) {
  switch (stroke.key) {
    case Key::Text:
      return stroke.text;
    case Key::Backspace:
      return "Backspace";
    case Key::Enter:
      return "Enter";
    case Key::Left:
      return "Left";
    case Key::Escape:
      return "Escape";
    case Key::WindowClosed:
      return "WindowClosed";
    case Key::Pointer:
      return fmt::format("Pointer{} {:.4f} {:.4f}", stroke.button, stroke.x, stroke.y);
    case Key::Button:
      return fmt::format("Button{}", stroke.button);
  }
  return {};
}

}  // namespace bimodal::runner

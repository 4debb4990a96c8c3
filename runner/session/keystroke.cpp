#include "runner/session/keystroke.hpp"

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
  }
  return {};
}

}  // namespace bimodal::runner

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "protocols/model/response.hpp"
#include "runner/session/keystroke.hpp"
#include "runner/session/option_grid.hpp"

namespace bimodal::runner {

/// What can be chosen, and by what.
struct ChoiceRules {
  std::vector<protocols::Option> options;
  std::vector<OptionBox> boxes;  ///< one an option, that can be clicked; none: without pointer
  bool confirm = false;          ///< a choice may be changed until Enter
};

/// The option that a stroke stands for: its key, in any case (a to z), its button, or a click of
/// the left mouse button into its box. Absent: it stands for none.
[[nodiscard]] std::optional<std::size_t> option_of(const ChoiceRules& rules,
                                                   const Keystroke& stroke);

/// A stroke that stands for an option, the inverse: its key if it has one, else its button, else a
/// click into the middle of its box. Without an instant. Precondition: the option has one of them.
[[nodiscard]] Keystroke stroke_for(const ChoiceRules& rules, std::size_t option);

}  // namespace bimodal::runner

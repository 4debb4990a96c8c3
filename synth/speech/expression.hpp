#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "synth/speech/control.hpp"

namespace bimodal::synth {

/// How much an expression at full strength adds to a control.
struct ExpressionShare {
  Control control;
  double amount;  ///< in the control's own unit
};

/// What a face shows on top of speech.
struct Expression {
  std::string_view name;
  std::string_view meaning;
  std::span<const ExpressionShare> shares;
};

/// The expressions that can be shown, chosen by eye after common descriptions of the faces of
/// emotion; they are no stimuli validated for emotion.
[[nodiscard]] std::span<const Expression> expressions();

[[nodiscard]] const Expression* expression_from_name(std::string_view name);

/// One expression and how strongly it is shown, 0 to 1.
struct ShownExpression {
  const Expression* expression = nullptr;
  double strength = 1;
};

/// The pose with expressions added. Speech keeps its contacts: lips that shut, and a lower lip at
/// the teeth, still do, since these are made after everything else; and where the lips are narrowed
/// for speech, what an expression adds to them counts the less (not at all from 16 mm on), so that
/// rounding stays.
[[nodiscard]] Pose with_expressions(const Pose& pose, std::span<const ShownExpression> shown);

}  // namespace bimodal::synth

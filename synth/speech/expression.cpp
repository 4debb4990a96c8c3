#include "synth/speech/expression.hpp"

#include <algorithm>
#include <array>

namespace bimodal::synth {

namespace {

using enum Control;

constexpr std::array kSmile{ExpressionShare{LipWidth, 5},
                            ExpressionShare{CornerY, 3.5},
                            ExpressionShare{CornerX, 1},
                            ExpressionShare{UpperLipRaise, 0.8},
                            ExpressionShare{LidClosure, 0.14},
                            ExpressionShare{BrowRaise, 0.6}};
constexpr std::array kSurprise{
    ExpressionShare{BrowRaise, 7}, ExpressionShare{LidClosure, -0.22}, ExpressionShare{Jaw, 4}};
constexpr std::array kSadness{ExpressionShare{CornerY, -3.5},
                              ExpressionShare{BrowRaise, 2},
                              ExpressionShare{LidClosure, 0.22},
                              ExpressionShare{LowerLipRaise, 1.2},
                              ExpressionShare{HeadPitch, 5},
                              ExpressionShare{GazeY, 5}};
constexpr std::array kAnger{ExpressionShare{BrowRaise, -3.6},
                            ExpressionShare{LidClosure, 0.08},
                            ExpressionShare{LipCompression, 0.35},
                            ExpressionShare{CornerY, -1.2},
                            ExpressionShare{JawThrust, 1}};
constexpr std::array kDisgust{ExpressionShare{UpperLipRaise, 3},
                              ExpressionShare{CornerY, -1.5},
                              ExpressionShare{BrowRaise, -2.5},
                              ExpressionShare{LidClosure, 0.2}};
constexpr std::array kFear{ExpressionShare{BrowRaise, 5},
                           ExpressionShare{LidClosure, -0.25},
                           ExpressionShare{LipWidth, 4},
                           ExpressionShare{CornerY, -1.5},
                           ExpressionShare{Jaw, 2}};

constexpr std::array kExpressions{
    Expression{"smile", "corners up and apart, lower lids up", kSmile},
    Expression{"surprise", "brows up, eyes wide, jaw down", kSurprise},
    Expression{"sadness", "corners down, lids heavy, head and gaze down", kSadness},
    Expression{"anger", "brows down, lips pressed", kAnger},
    Expression{"disgust", "upper lip up, corners and brows down", kDisgust},
    Expression{"fear", "brows up, eyes wide, lips drawn apart", kFear},
};

constexpr double kFullNarrowing = 16.0;  // mm; here the opening is zipped from its corners

bool is_of_lips(Control control) {
  return control <= CheekPuff && control != Jaw && control != JawThrust;
}

}  // namespace

std::span<const Expression> expressions() {
  return kExpressions;
}

const Expression* expression_from_name(std::string_view name) {
  const auto* const found = std::ranges::find(kExpressions, name, &Expression::name);
  return found == kExpressions.end() ? nullptr : found;
}

Pose with_expressions(const Pose& pose, std::span<const ShownExpression> shown) {
  Pose result = pose;
  const double free = 1.0 - std::clamp(-value(pose, LipWidth) / kFullNarrowing, 0.0, 1.0);
  for (const auto& [expression, strength] : shown) {
    for (const auto& [control, amount] : expression->shares) {
      value(result, control) += strength * amount * (is_of_lips(control) ? free : 1.0);
    }
  }
  return result;
}

}  // namespace bimodal::synth

#include "synth/speech/expression.hpp"

#include <array>
#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/synth/face/the_head.hpp"

namespace bimodal::synth {
namespace {

using enum Control;

ShownExpression shown(std::string_view name, double strength = 1) {
  return {expression_from_name(name), strength};
}

TEST(Expressions, HaveNamesOfTheirOwnAndStayWithinTheFace) {
  std::set<std::string_view> names;
  for (const auto& expression : expressions()) {
    EXPECT_TRUE(names.insert(expression.name).second) << expression.name;
    EXPECT_EQ(expression_from_name(expression.name), &expression);
    for (const auto& [control, amount] : expression.shares) {
      const auto& range = describe(control);
      EXPECT_GE(range.neutral + amount, range.lowest) << expression.name << ' ' << range.name;
      EXPECT_LE(range.neutral + amount, range.highest) << expression.name << ' ' << range.name;
    }
  }
  EXPECT_EQ(expression_from_name("boredom"), nullptr);
}

TEST(Expressions, AddInProportionToTheirStrength) {
  const auto half = with_expressions(neutral_pose(), std::array{shown("smile", 0.5)});
  const auto full = with_expressions(neutral_pose(), std::array{shown("smile")});
  EXPECT_NEAR(2 * value(half, CornerY), value(full, CornerY), 1e-12);
  EXPECT_EQ(with_expressions(neutral_pose(), {}), neutral_pose());
}

TEST(Expressions, AddToEachOther) {
  const auto both = with_expressions(neutral_pose(), std::array{shown("surprise"), shown("anger")});
  EXPECT_NEAR(value(both, BrowRaise), 7 - 3.6, 1e-12);
}

TEST(Expressions, LiftTheDrawnCorners) {
  const auto smiling = posed(with_expressions(neutral_pose(), std::array{shown("smile")}));
  const auto sad = posed(with_expressions(neutral_pose(), std::array{shown("sadness")}));
  EXPECT_GT(smiling.lips.corner_up_mm, 1.5);
  EXPECT_LT(sad.lips.corner_up_mm, -1.5);
  EXPECT_GT(smiling.lips.outer_width_mm, posed(neutral_pose()).lips.outer_width_mm + 4);
}

TEST(Expressions, LeaveTheLipsOfPShut) {
  for (const auto& expression : expressions()) {
    const auto pose = with_expressions(pose_of({{LipClosure, 1}, {LipCompression, 0.5}, {Jaw, 3}}),
                                       std::array{ShownExpression{&expression, 1}});
    EXPECT_LT(posed(pose).lips.largest_gap_mm, 0.05) << expression.name;
  }
}

TEST(Expressions, LeaveRoundedLipsRound) {
  const Pose rounded = pose_of({{LipWidth, -18}, {LipProtrusion, 7}, {Jaw, 3}});
  for (const auto& expression : expressions()) {
    const auto pose = with_expressions(rounded, std::array{ShownExpression{&expression, 1}});
    EXPECT_EQ(value(pose, LipWidth), -18) << expression.name;
  }
}

}  // namespace
}  // namespace bimodal::synth

#include "synth/fitting/agreement.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace bimodal::synth {
namespace {

TEST(Agreement, OfTheSameIsPerfect) {
  const std::vector<double> values{1, 3, 2, 5};
  const auto found = agreement(values, values);
  EXPECT_DOUBLE_EQ(found.r.value(), 1);
  EXPECT_EQ(found.rmse(), 0);
  EXPECT_NEAR(found.rmse_scaled(), 0, 1e-12);
  EXPECT_DOUBLE_EQ(found.gain, 1);
  EXPECT_NEAR(found.offset, 0, 1e-12);
}

TEST(Agreement, TakesOutTheTalkersOffsetAndGain) {
  const std::vector<double> predicted{1, 3, 2, 5};
  const std::vector<double> measured{12, 16, 14, 20};  // 10 + 2 x
  const auto found = agreement(predicted, measured);
  EXPECT_DOUBLE_EQ(found.gain, 2);
  EXPECT_DOUBLE_EQ(found.offset, 10);
  EXPECT_NEAR(found.rmse_scaled(), 0, 1e-6);
  EXPECT_DOUBLE_EQ(found.squares, 11 * 11 + 13 * 13 + 12 * 12 + 15 * 15);
}

TEST(Agreement, HasNoCorrelationWhereNothingVaries) {
  const std::vector<double> constant{0.1, 0.1, 0.1};
  const std::vector<double> values{1, 2, 4};
  EXPECT_FALSE(agreement(constant, values).r);
  EXPECT_FALSE(agreement(values, constant).r);
  EXPECT_EQ(agreement(constant, values).gain, 0);
}

TEST(Agreement, OverClipsIsTheMeanCorrelationAndAllSquares) {
  const std::array clips{Agreement{.instants = 10, .r = 0.5, .squares = 40, .squares_scaled = 10},
                         Agreement{.instants = 30, .r = 0.9, .squares = 120, .squares_scaled = 30},
                         Agreement{.instants = 10}};
  const auto all = over_clips(clips);
  EXPECT_EQ(all.instants, 50);
  EXPECT_DOUBLE_EQ(all.r.value(), 0.7);
  EXPECT_DOUBLE_EQ(all.rmse() * all.rmse(), 3.2);
  EXPECT_DOUBLE_EQ(all.rmse_scaled() * all.rmse_scaled(), 0.8);
}

}  // namespace
}  // namespace bimodal::synth
